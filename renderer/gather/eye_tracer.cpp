#include "gather/eye_tracer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "gather/first_look.h"
#include "gather/lamp_rays.h"
#include "gather/shade.h"
#include "scene/albedo.h"
#include "scene/filter_axis.h"
#include "scene/vectors.h"

namespace brewster {

void LevelLight::clear(std::size_t size) {
    const auto zero = [&](auto& rows) {
        for (auto& row : rows) std::fill_n(row.begin(), size, 0.0f);
    };
    zero(stokes);
    zero(unpolarized);
    zero(error);
    zero(polarized_error);
    zero(unpolarized_error);
    std::fill_n(coarse.begin(), size, 0.0f);
}

/// A power of two, so that the hash has no remainder.
constexpr std::uint32_t draws_for_a_wide_ray = 16;

/// Adds the time since the last lap to a stage.
class StageClock {
  public:
    explicit StageClock(EyeStageSeconds& seconds) : seconds_(seconds) {}
    void lap(EyeStage stage) {
        const Clock::time_point now = Clock::now();
        seconds_[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    using Clock = std::chrono::steady_clock;
    EyeStageSeconds& seconds_;
    Clock::time_point last_ = Clock::now();
};

struct EyeTracer::Storage {
    Level& level(std::size_t depth) {
        while (levels.size() <= depth) levels.push_back(std::make_unique<Level>());
        return *levels[depth];
    }

    std::vector<std::unique_ptr<Level>> levels;
    std::vector<Segment> segments, next_segments;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<std::uint32_t> order;
    BatchNumbers numbers;
    Entered entered;
    LampRays lamps;
    std::array<Onwards, 2> onwards;
    LevelLight brought, alone;
    EyeStageSeconds seconds{};
    EventNumbers events;
};

template <int components>
class EyeTracer::Batch {
  public:
    Batch(const EyeScene& scene, const Snapshot& bins, std::span<const Draw> draws, Storage& storage)
        : scene_(scene), bins_(bins), draws_(draws), s_(storage) {}

    void start(const Camera& camera, int width, int height) {
        const PictureRays picture(camera, width, height);
        s_.segments.clear();
        for (std::uint32_t i = 0; i < draws_.size(); ++i) {
            const EyeNumbers& numbers = draws_[i].numbers;
            s_.numbers.keys[i] = numbers.key;
            s_.numbers.indices[i] = numbers.index;
            const auto place = number_pair<float>(numbers.key, numbers.index, place_dimension);
            Segment segment;
            segment.ray.origin = camera.position;
            segment.ray.direction = picture.direction(static_cast<float>(draws_[i].column) + place[0],
                                                      static_cast<float>(draws_[i].row) + place[1]);
            segment.axis = normalized(cross(eye_vector(segment.ray.direction), eye_vector(camera.up)));
            segment.draw = segment.parent = i;
            s_.segments.push_back(segment);
        }
    }

    /// Takes the segments to a level; what follows them becomes the next segments.
    void take(std::size_t depth) {
        Level& level = s_.level(depth);
        StageClock clock(s_.seconds);
        meet(level, depth == 0);
        clock.lap(EyeStage::hits);
        s_.next_segments.clear();
        for (const Group& group : level.groups) {
            const PreparedMaterial& material = scene_.materials[group.material];
            if (!material.diffuse()) continue;
            read_entered(bins_, group.first, group.end, level, s_.entered);
            light_of_entered(material, level, group, level.light);
        }
        clock.lap(EyeStage::bins);
        if (scene_.lamps.any())
            s_.lamps.light<components>(scene_, s_.numbers, static_cast<std::uint32_t>(depth), level);
        clock.lap(EyeStage::lamps);
        for (const Group& group : level.groups) go_on_from(level, group, static_cast<std::uint32_t>(depth));
        s_.segments.swap(s_.next_segments);
        clock.lap(EyeStage::onwards);
    }

    bool done() const { return s_.segments.empty(); }

    void bring_back_from(std::size_t depth) {
        const Level& next = s_.level(depth);
        Level& level = s_.level(depth - 1);
        StageClock clock(s_.seconds);
        over({0, false, 0, next.size},
             [&]<class Real>(std::uint32_t k) { bring_back<components, Real>(next, k, s_.brought, level); });
        add_brought<components>(next, s_.brought, level);
        clock.lap(EyeStage::back);
    }

    /// What the bins alone say of the first level, for draws that ask; that level must have been taken.
    void read_bins(BinsAlone& alone) {
        std::fill_n(alone.known.begin(), draws_.size(), false);
        if (std::none_of(draws_.begin(), draws_.end(), [](const Draw& draw) { return draw.reads_bins; })) return;
        const Level& first = s_.level(0);
        s_.alone.clear(first.size);
        for (const Group& group : first.groups) {
            const PreparedMaterial& material = scene_.materials[group.material];
            if (material.base == Base::transparent || !material.rough() || material.emission != glm::vec3(0.0f))
                continue;
            const auto wanted = [&](std::uint32_t i) { return draws_[first.draw[i]].reads_bins; };
            bool any = false;
            for (std::uint32_t i = group.first; i < group.end; ++i) any = any || wanted(i);
            if (!any) continue;
            if (material.diffuse()) {
                read_all_entered(bins_, first, group.first, group.end, s_.entered);
                light_of_entered(material, first, group, s_.alone);
            }
            for (std::uint32_t i = group.first; i < group.end; ++i) {
                if (!wanted(i)) continue;
                add_gloss_of_bins<components>(scene_.scene, bins_, first, s_.alone, i);
                alone.known[first.draw[i]] = true;
            }
        }
        hand_over(s_.alone, alone.light);
    }

    void hand_over(LevelLight& seen) const { hand_over(s_.level(0).light, seen); }

  private:
    /// Light along the rays of the first level as that of their draws.
    void hand_over(const LevelLight& light, LevelLight& seen) const {
        const Level& first = s_.level(0);
        const auto put = [&](const auto& from, auto& to) {
            for (std::size_t row = 0; row < from.size(); ++row)
                for (std::uint32_t k = 0; k < first.size; ++k) to[row][first.parent[k]] = from[row][k];
        };
        put(light.stokes, seen.stokes);
        put(light.unpolarized, seen.unpolarized);
        put(light.error, seen.error);
        put(light.polarized_error, seen.polarized_error);
        put(light.unpolarized_error, seen.unpolarized_error);
        for (std::uint32_t k = 0; k < first.size; ++k) seen.coarse[first.parent[k]] = light.coarse[k];
    }

    void meet(Level& level, bool first_look) {
        const std::vector<Segment>& segments = s_.segments;
        s_.rays.clear();
        for (const Segment& segment : segments) s_.rays.push_back(segment.ray);
        s_.hits.resize(segments.size());
        scene_.rays.intersect(s_.rays, s_.hits);
        if (first_look) look_past_backs(scene_.rays, s_.rays, s_.hits);

        BREWSTER_CHECK(segments.size() <= most_rays, std::to_string(segments.size()));
        level.size = static_cast<std::uint32_t>(segments.size());
        sort(level);
        level.light.clear(level.size);
        const Scene& scene = scene_.scene;
        for (std::uint32_t i = 0; i < level.size; ++i) {
            const Segment& segment = segments[s_.order[i]];
            const Hit& hit = s_.hits[s_.order[i]];
            level.parent[i] = segment.parent;
            level.parent_way[i] = segment.parent + segment.way * static_cast<std::uint32_t>(most_rays);
            level.eagerness[i] = segment.parted || segment.rough > 0 ? 0.0f : draws_[segment.draw].eagerness;
            level.draw[i] = segment.draw;
            level.rough_events[i] = segment.rough;
            level.sharp_events[i] = segment.sharp;
            level.tolerance[i] = draws_[segment.draw].tolerance;
            level.gathers[i] = std::isfinite(level.tolerance[i]) && segment.rough == 0 && scene_.ends_anywhere ? 1 : 0;
            level.throughput[i] = segment.throughput;
            level.reads_direct[i] = segment.rough > 0 || level.ends_in_bins(i) ? 1.0f : 0.0f;
            store_vector(eye_vector(segment.ray.direction), level.direction, i);
            store_vector(segment.axis, level.axis, i);
            if (hit.chart == no_chart) {
                if (hit.escaped() && !segment.gathers) add_discs(segment, level.light, i);
                continue;
            }
            level.chart[i] = hit.chart;
            level.triangle[i] = hit.triangle;
            level.u[i] = hit.u;
            level.v[i] = hit.v;
            store_vector(eye_vector(hit.position), level.position, i);
            store_vector(eye_vector(hit.normal), level.normal, i);
            store_vector(eye_vector(hit.shading_normal), level.shading_normal, i);
            const PreparedMaterial& material = scene_.materials[scene.charts[hit.chart].material];
            if (material.emission != glm::vec3(0.0f) && !segment.gathers)
                add_emission(segment, hit, material, level.light, i);
            choose_wide_ray(segment, material, level, i);
            if (material.filter != FilterKind::none)
                store_vector(single_vector(filter_axis(material, scene.charts[hit.chart])), level.filter_axis, i);
            if (scene_.coloured && material.diffuse()) {
                const glm::vec4 tint = tint_at(scene, hit.triangle, hit.b1, hit.b2);
                for (std::size_t band = 0; band < band_count; ++band)
                    level.tint[band][i] = material.tinted_base(band, tint[static_cast<int>(band)]);
            }
        }
    }

    // At the first gloss on a path that has not parted at glass. Every so many draws of a sequence have one wide ray, which
    // of them is hashed: each has it with the same probability, however many there will be.
    void choose_wide_ray(const Segment& segment, const PreparedMaterial& material, Level& level,
                         std::uint32_t i) const {
        level.wide_share[i] = 0;
        level.widely[i] = 0;
        if (segment.rough > 0 || segment.parted || !draws_[segment.draw].goes_wide ||
            material.base == Base::transparent || !material.rough() || level.ends_in_bins(i))
            return;
        level.wide_share[i] = 1.0f / draws_for_a_wide_ray;
        const EyeNumbers& numbers = draws_[segment.draw].numbers;
        const std::uint32_t turn = mixed_bits(numbers.key + mixed_bits(numbers.index / draws_for_a_wide_ray));
        if (numbers.index % draws_for_a_wide_ray != turn % draws_for_a_wide_ray) return;
        level.widely[i] = 1;
        level.gathers[i] = 0;  // a path parts once
    }

    // Entries of one material and side come together, in the order of the segments; those without a surface last.
    void sort(Level& level) {
        const Scene& scene = scene_.scene;
        const std::size_t kinds = 2 * scene_.materials.size() + 1;
        const auto kind_of = [&](std::uint32_t segment) {
            const Hit& hit = s_.hits[segment];
            if (hit.chart == no_chart) return kinds - 1;
            const glm::vec3& d = s_.segments[segment].ray.direction;
            if (!(-glm::dot(d, hit.shading_normal) > 1e-6f)) return kinds - 1;
            const std::uint32_t index = scene.charts[hit.chart].material;
            const PreparedMaterial& material = scene_.materials[index];
            const bool inside = material.base == Base::transparent && !material.thin &&
                                hit.chart == scene.triangles[hit.triangle].back_chart;
            return 2 * static_cast<std::size_t>(index) + (inside ? 1 : 0);
        };
        kinds_.resize(level.size);
        counts_.assign(kinds + 1, 0);
        for (std::uint32_t i = 0; i < level.size; ++i) {
            kinds_[i] = static_cast<std::uint32_t>(kind_of(i));
            ++counts_[kinds_[i] + 1];
        }
        for (std::size_t k = 0; k < kinds; ++k) counts_[k + 1] += counts_[k];
        level.groups.clear();
        for (std::uint32_t k = 0; k + 1 < kinds; ++k)
            if (counts_[k + 1] > counts_[k]) level.groups.push_back({k / 2, k % 2 == 1, counts_[k], counts_[k + 1]});
        s_.order.resize(level.size);
        for (std::uint32_t i = 0; i < level.size; ++i) s_.order[counts_[kinds_[i]]++] = i;
    }

    void add_emission(const Segment& segment, const Hit& hit, const PreparedMaterial& material, LevelLight& light,
                      std::uint32_t i) const {
        float weight = 1;
        if (segment.pdf > 0) {
            const double pdf =
                scene_.lamps.pdf_of_area(hit.chart, hit.triangle, vector_of(segment.ray.origin), vector_of(hit.normal),
                                         vector_of(segment.ray.direction), static_cast<double>(hit.distance));
            weight = heuristic_share(segment.pdf, static_cast<float>(pdf));
        }
        for (std::size_t band = 0; band < band_count; ++band) {
            const float radiance = weight * material.emission[static_cast<int>(band)];
            light.stokes[band][i] += radiance;
            light.unpolarized[band][i] += radiance;
        }
    }

    void add_discs(const Segment& segment, LevelLight& light, std::uint32_t i) const {
        const Vector<double> direction = vector_of(segment.ray.direction);
        scene_.lamps.discs_seen(direction, [&](const LampLight& seen) {
            const Lamp& lamp = scene_.scene.lamps[seen.lamp];
            const float weight = segment.pdf > 0 ? heuristic_share(segment.pdf, static_cast<float>(seen.pdf)) : 1.0f;
            const Vector<double> light_in = -direction;
            const auto turn = rotation_between(light_in, lamp_axis(lamp, light_in), double_vector(segment.axis));
            const Stokes<double, components> state = rotate(turn, lamp_state<components>(lamp));
            for (std::size_t band = 0; band < band_count; ++band) {
                const float radiance = weight * static_cast<float>(seen.radiance[static_cast<int>(band)]);
                for (std::size_t j = 0; j < components; ++j)
                    light.stokes[3 * j + band][i] += radiance * static_cast<float>(state[static_cast<int>(j)]);
                light.unpolarized[band][i] += radiance;
            }
        });
    }

    void light_of_entered(const PreparedMaterial& material, const Level& level, const Group& group, LevelLight& light) {
        over(group, [&]<class Real>(std::uint32_t i) {
            add_base<components, Real>(material, scene_.coloured, s_.entered, level, light, i);
        });
    }

    void go_on_from(Level& level, const Group& group, std::uint32_t vertex) {
        const PreparedMaterial& material = scene_.materials[group.material];
        const bool transparent = material.base == Base::transparent;
        if (material.diffuse()) gather_from(level, group, vertex);
        if (!transparent && !material.reflects()) return;
        go_widely_from(level, group, vertex);
        s_.numbers.draw(level, group, facet_dimension(vertex), s_.events.facet_u, s_.events.facet_v);
        s_.numbers.draw(level, group, choice_dimension(vertex), s_.events.choice, s_.events.slope);
        over(group, [&]<class Real>(std::uint32_t i) {
            go_on<Real>(material, group.inside, s_.events, level, s_.onwards, i);
        });
        for (std::uint32_t i = group.first; i < group.end; ++i) {
            if (transparent) {
                if (level.sharp_events[i] >= most_events_of_glass) continue;
                const bool both = s_.onwards[0].share[i] > 0 && s_.onwards[1].share[i] > 0;
                for (std::uint8_t way = 0; way < 2; ++way)
                    if (Segment* next = next_segment(level, i, way)) next->parted = next->parted || both;
            } else if (level.ends_in_bins(i)) {
                add_gloss_of_bins<components>(scene_.scene, bins_, level, level.light, i);
            } else {
                next_segment(level, i, 0);
            }
        }
    }

    // On the second way: only glass has two of its own.
    void gather_from(Level& level, const Group& group, std::uint32_t vertex) {
        const auto first = level.gathers.begin() + group.first, end = level.gathers.begin() + group.end;
        if (std::find(first, end, 1) == end) return;
        s_.numbers.draw(level, group, exit_dimension(vertex), s_.events.exit_u, s_.events.exit_v);
        over(group, [&]<class Real>(std::uint32_t i) {
            go_into_base<Real>(scene_.materials[group.material], scene_.coloured, s_.events, level, s_.onwards[1], i);
        });
        for (std::uint32_t i = group.first; i < group.end; ++i) {
            if (level.gathers[i] == 0) continue;
            if (Segment* next = next_segment(level, i, 1)) {
                next->rough = most_rough_events;
                next->gathers = true;
            }
        }
    }

    // On the second way, too; few entries do, so one at a time.
    void go_widely_from(Level& level, const Group& group, std::uint32_t vertex) {
        for (std::uint32_t i = group.first; i < group.end; ++i) {
            if (level.widely[i] == 0) continue;
            const EyeNumbers& numbers = draws_[level.draw[i]].numbers;
            const auto pair = number_pair<float>(numbers.key, numbers.index, exit_dimension(vertex));
            leave_gloss_widely(scene_.materials[group.material], pair, level, s_.onwards[1], i);
            next_segment(level, i, 1);
        }
    }

    // What follows entry i on one of its ways on; none where nothing can come from there. Good until the next call.
    Segment* next_segment(const Level& level, std::uint32_t i, std::uint8_t way) {
        const Onwards& onwards = s_.onwards[way];
        const float throughput = level.throughput[i] * onwards.share[i];
        if (!(throughput > 0)) return nullptr;
        Segment next;
        next.ray = {eye_coordinates(load_vector<float>(level.position, i)),
                    eye_coordinates(load_vector<float>(onwards.direction, i)), level.triangle[i]};
        next.axis = load_vector<float>(onwards.axis, i);
        next.throughput = throughput;
        next.pdf = onwards.pdf[i];
        next.draw = level.draw[i];
        next.parent = i;
        next.way = way;
        const bool sharp = onwards.sharp[i] > 0;
        next.rough = static_cast<std::uint8_t>(static_cast<int>(level.rough_events[i]) + (sharp ? 0 : 1));
        next.sharp = static_cast<std::uint8_t>(level.sharp_events[i] + (sharp ? 1 : 0));
        next.parted = level.eagerness[i] == 0;
        s_.next_segments.push_back(next);
        return &s_.next_segments.back();
    }

    const EyeScene& scene_;
    const Snapshot& bins_;
    const std::span<const Draw> draws_;
    Storage& s_;
    std::vector<std::uint32_t> kinds_, counts_;
};

EyeTracer::EyeTracer() : storage_(std::make_unique<Storage>()) {}
EyeTracer::~EyeTracer() = default;

const EyeStageSeconds& EyeTracer::stage_seconds() const {
    return storage_->seconds;
}

void EyeTracer::trace(const EyeScene& scene, const Snapshot& bins, const Camera& camera, int width, int height,
                      std::span<const Draw> draws, LevelLight& seen, BinsAlone* alone) {
    BREWSTER_CHECK(draws.size() <= eye_batch, std::to_string(draws.size()));
    const auto run = [&](auto batch) {
        batch.start(camera, width, height);
        std::size_t depth = 0;
        for (; !batch.done(); ++depth) batch.take(depth);
        if (alone) batch.read_bins(*alone);
        for (std::size_t d = depth; d-- > 1;) batch.bring_back_from(d);
        batch.hand_over(seen);
    };
    if (scene.components == 1)
        run(Batch<1>(scene, bins, draws, *storage_));
    else
        run(Batch<4>(scene, bins, draws, *storage_));
}

}  // namespace brewster
