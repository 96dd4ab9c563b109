#pragma once
#include <array>
#include <span>

#include "scene/landing.h"
#include "scene/rays.h"
#include "transport/meeting.h"

namespace brewster::transport {

namespace land_detail {

inline constexpr std::size_t triangle_rows = sizeof(LandingTriangle) / sizeof(Row);
inline constexpr std::size_t chart_rows = sizeof(LandingChart) / sizeof(Row);

/// Rows of records, one a lane, as columns.
template <std::size_t rows, class Record>
std::array<FloatLanes, rows * row_size> columns_of(const std::vector<Record>& records,
                                                   const std::array<std::uint32_t, lane_count>& index) {
    std::array<FloatLanes, rows * row_size> all;
    for (std::size_t row = 0; row < rows; ++row) {
        const Columns columns = load_columns([&](int lane) {
            return reinterpret_cast<const float*>(&records[index[static_cast<std::size_t>(lane)]]) + row * row_size;
        });
        for (std::size_t j = 0; j < row_size; ++j) all[row * row_size + j] = columns[j];
    }
    return all;
}

template <std::size_t at, std::size_t size>
Vector<FloatLanes> vector_at(const std::array<FloatLanes, size>& columns) {
    return {columns[at], columns[at + 1], columns[at + 2]};
}

}  // namespace land_detail

/// Where a batch of rays along `direction` land on the charts of one material and side: Rays::intersect in lanes.
inline Meeting<FloatLanes> land(const LandingTable& table, const std::array<TriangleHit, lane_count>& hits,
                                const Vector<FloatLanes>& direction) {
    using namespace land_detail;
    std::array<std::uint32_t, lane_count> index;
    std::array<float, lane_count> b1, b2;
    bool smooth = false;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        index[lane] = hits[lane].triangle;
        b1[lane] = hits[lane].b1;
        b2[lane] = hits[lane].b2;
        smooth = smooth || table.triangles[index[lane]].smooth != 0;
    }
    Meeting<FloatLanes> at;
    at.triangle = load_words(index.data());
    at.barycentric = {load<FloatLanes>(b1.data()), load<FloatLanes>(b2.data())};

    const auto triangle = columns_of<triangle_rows>(table.triangles, index);
    const TriangleShape<FloatLanes> shape{vector_at<0>(triangle), vector_at<3>(triangle), vector_at<6>(triangle),
                                          vector_at<9>(triangle)};
    at.position = point_inside(shape, at.barycentric);
    const Vector<FloatLanes> front = vector_at<12>(triangle);
    const LaneMask from_front = is_met_in_front(front, direction);
    at.normal = select(from_front, front, -front);
    at.shading_normal = at.normal;
    if (smooth) {
        const auto corners = columns_of<2>(table.normals, index);
        const Vector<FloatLanes> shading = interpolated_normal(
            {vector_at<0>(corners), vector_at<3>(corners), vector_at<6>(corners)}, front, at.barycentric);
        at.shading_normal = select(from_front, shading, -shading);
    }

    at.chart = select(from_front, words_of(triangle[16]), words_of(triangle[17]));
    store(at.chart, index.data());
    const auto chart = columns_of<chart_rows>(table.charts, index);
    at.axis_u = vector_at<3>(chart);
    at.axis_v = vector_at<6>(chart);
    at.chart_normal = vector_at<11>(chart);
    const UnitCoordinates<FloatLanes> uv =
        unit_coordinates({vector_at<0>(chart), at.axis_u, at.axis_v, chart[9], chart[10]}, at.position);
    at.u = fixed_coordinate(uv.u);
    at.v = fixed_coordinate(uv.v);
    return at;
}

}  // namespace brewster::transport
