#include "scene/emission.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "base/rows.h"
#include "scene/landing.h"
#include "scene/start_direction.h"
#include "scene/vectors.h"

namespace brewster {
namespace {

static_assert(sizeof(StartRow) == 3 * sizeof(Row));

// One row a triangle, sharing out the first number by area.
void add_rows(const Scene& scene, const Chart& chart, std::vector<StartRow>& rows) {
    const std::vector<double> shares = scene.area_shares(chart);
    double before = 0;
    for (std::uint32_t i = 0; i < chart.triangle_count; ++i) {
        const Triangle& triangle = scene.triangles[chart.first_triangle + i];
        const Frame frame = chart.curved ? chart.frame_about(scene.facet_normal(triangle)) : chart.frame();
        StartRow row;
        row.corner = scene.vertices[triangle.vertices[0]];
        row.edge1 = scene.vertices[triangle.vertices[1]] - row.corner;
        row.edge2 = scene.vertices[triangle.vertices[2]] - row.corner;
        row.shape = triangle.margin;
        row.axis_u = frame.u;
        row.axis_v = frame.v;
        row.middle = frame.normal;
        row.before = static_cast<float>(before);
        row.scale = static_cast<float>(1 / (shares[i] - before));
        row.leaving = chart.first_triangle + i;
        rows.push_back(row);
        before = shares[i];
    }
}

StartRow row_of_sun(const Lamp& lamp, const SunRectangle& sun) {
    StartRow row;
    row.corner = sun.centre - sun.half_u - sun.half_v;
    row.edge1 = 2.0f * sun.half_u;
    row.edge2 = 2.0f * sun.half_v;
    row.shape.x = sine_of_radius(lamp);
    row.middle = lamp.direction;
    row.axis_u = across(lamp.direction);
    row.axis_v = glm::cross(row.middle, row.axis_u);
    return row;
}

StartRow row_of_spot(const Lamp& lamp) {
    StartRow row;
    row.corner = lamp.position;
    row.shape = {lamp.cos_inner, lamp.cos_outer, 0};
    row.middle = lamp.direction;
    row.axis_u = across(lamp.direction);
    row.axis_v = glm::cross(row.middle, row.axis_u);
    return row;
}

// Rows of one lane or of all as columns of numbers.
std::array<float, 24> columns_of(const std::vector<StartRow>& rows, std::uint32_t index) {
    std::array<float, 24> columns;
    std::copy_n(reinterpret_cast<const float*>(&rows[index]), columns.size(), columns.begin());
    return columns;
}
std::array<FloatLanes, 24> columns_of(const std::vector<StartRow>& rows, WordLanes index) {
    std::array<std::uint32_t, lane_count> indices;
    store(index, indices.data());
    std::array<FloatLanes, 24> columns;
    for (std::size_t first = 0; first < columns.size(); first += row_size) {
        const Columns some = load_columns([&](int lane) {
            return reinterpret_cast<const float*>(&rows[indices[static_cast<std::size_t>(lane)]]) + first;
        });
        std::copy_n(some.begin(), row_size, columns.begin() + static_cast<std::ptrdiff_t>(first));
    }
    return columns;
}

template <std::size_t at, class Real>
Vector<Real> vector_at(const std::array<Real, 24>& columns) {
    return {columns[at], columns[at + 1], columns[at + 2]};
}

// The point of a triangle for two numbers, by folding the unit square's far half back. Unlike the square root, this
// keeps a lattice of numbers a lattice of points.
template <class Real>
Barycentric<Real> fold(const Real& x, const Real& y) {
    const auto far = x + y > 1;
    return {select(far, 1 - x, x), select(far, 1 - y, y)};
}

template <class Real, class Function>
auto of_each(const Word<Real>& x, const Function& function) {
    if constexpr (std::is_same_v<Real, float>) {
        return function(x, std::size_t{0});
    } else {
        std::array<std::uint32_t, lane_count> lanes;
        store(x, lanes.data());
        for (std::size_t lane = 0; lane < lane_count; ++lane) lanes[lane] = function(lanes[lane], lane);
        return load_words(lanes.data());
    }
}

}  // namespace

LampSampler::LampSampler(const Scene& scene) : scene_(scene) {
    for (const Lamp& lamp : scene.lamps) {
        first_rows_.push_back(static_cast<std::uint32_t>(rows_.size()));
        suns_.push_back(lamp.kind == LampKind::sun
                            ? sun_rectangle(scene.low, scene.high, lamp.direction, lamp.angular_radius)
                            : SunRectangle{});
        if (lamp.kind == LampKind::area) {
            add_rows(scene, scene.charts[lamp.chart], rows_);
        } else if (lamp.kind == LampKind::sun) {
            rows_.push_back(row_of_sun(lamp, suns_.back()));
        } else if (lamp.kind == LampKind::spot) {
            rows_.push_back(row_of_spot(lamp));
        } else {
            rows_.emplace_back().corner = lamp.position;
        }
    }
    first_rows_.push_back(static_cast<std::uint32_t>(rows_.size()));
}

// The lamp's row for its first number.
std::uint32_t LampSampler::row_of(std::uint32_t lamp, float x) const {
    const auto begin = rows_.begin() + first_rows_[lamp], end = rows_.begin() + first_rows_[lamp + 1];
    const auto behind =
        std::upper_bound(begin + 1, end, x, [](float number, const StartRow& row) { return number < row.before; });
    return static_cast<std::uint32_t>(behind - rows_.begin()) - 1;
}

template <class Real>
PhotonStart<Real> LampSampler::start(const Word<Real>& lamp, const std::array<Real, 4>& x) const {
    std::array<float, sizeof(Real) / sizeof(float)> first;
    store(x[0], first.data());
    std::array<bool, 4> present{};
    std::array<std::uint32_t, first.size()> kinds;
    const Word<Real> row = of_each<Real>(lamp, [&](std::uint32_t index, std::size_t lane) {
        kinds[lane] = static_cast<std::uint32_t>(scene_.lamps[index].kind);
        present[kinds[lane]] = true;
        return row_of(index, first[lane]);
    });
    const Word<Real> kind_word = of_each<Real>(lamp, [&](std::uint32_t, std::size_t lane) { return kinds[lane]; });
    const auto is = [&](LampKind kind) { return equal(kind_word, Word<Real>(static_cast<std::uint32_t>(kind))); };
    const auto has = [&](LampKind kind) { return present[static_cast<std::size_t>(kind)]; };

    const auto columns = columns_of(rows_, row);
    const Vector<Real> corner = vector_at<0>(columns), edge1 = vector_at<3>(columns), edge2 = vector_at<6>(columns);
    PhotonStart<Real> start;
    start.leaving = words_of(columns[23]);
    start.position = corner + x[0] * edge1 + x[1] * edge2;
    Slant<Real> slant = sphere_slant(x[2]);
    if (has(LampKind::sun)) {
        const Slant<Real> disc = disc_slant(columns[9], x[2]);
        slant = {select(is(LampKind::sun), disc.sine, slant.sine),
                 select(is(LampKind::sun), disc.cosine, slant.cosine)};
    }
    if (has(LampKind::spot)) {
        const Slant<Real> spot = spot_slant(columns[9], columns[10], x[2]);
        slant = {select(is(LampKind::spot), spot.sine, slant.sine),
                 select(is(LampKind::spot), spot.cosine, slant.cosine)};
    }
    if (has(LampKind::area)) {
        const auto area = is(LampKind::area);
        const Real within = min((x[0] - columns[21]) * columns[22], constant<Real>(0x1.fffffep-1));
        const TriangleShape<Real> triangle{corner, edge1, edge2, vector_at<9>(columns)};
        start.position = select(area, point_inside(triangle, fold(within, x[1])), start.position);
        const Slant<Real> cosine = cosine_slant(x[2]);
        slant = {select(area, cosine.sine, slant.sine), select(area, cosine.cosine, slant.cosine)};
    }
    start.direction = turned_about(vector_at<12>(columns), vector_at<15>(columns), vector_at<18>(columns), slant, x[3]);
    return start;
}

template PhotonStart<float> LampSampler::start(const std::uint32_t&, const std::array<float, 4>&) const;
template PhotonStart<FloatLanes> LampSampler::start(const WordLanes&, const std::array<FloatLanes, 4>&) const;

Emission LampSampler::emit(std::uint32_t lamp, const std::array<float, 4>& x) const {
    const PhotonStart<float> alone = start<float>(lamp, x);
    return {glm_vector(alone.position), glm_vector(alone.direction), alone.leaving};
}

float LampSampler::pdf(std::uint32_t index, glm::vec3 direction) const {
    const Lamp& lamp = scene_.lamps[index];
    switch (lamp.kind) {
        case LampKind::area: {
            const Chart& chart = scene_.charts[lamp.chart];
            BREWSTER_CHECK(!chart.curved, chart.mesh + " is curved");
            return pdf_cosine(chart.normal, direction) / static_cast<float>(chart.area);
        }
        case LampKind::sun:
            return (lamp.angular_radius > 0 ? pdf_disc(lamp, direction) : 1.0f) / suns_[index].area;
        case LampKind::point:
            return pdf_sphere();
        case LampKind::spot:
            return pdf_spot(lamp, direction);
    }
    return 0.0f;
}

}  // namespace brewster
