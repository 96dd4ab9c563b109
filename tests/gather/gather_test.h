#pragma once
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bins/snapshot.h"
#include "engine/engine.h"
#include "gather/eye_tracer.h"
#include "gather/gather.h"
#include "shared/bin_layout.h"

namespace brewster {

inline bool never() {
    return false;
}

/// Bins of one leaf for each chart and tree that say the same everywhere: `direct` and `indirect` lux, known to
/// `standard_error`.
inline std::shared_ptr<Snapshot> even_bins(const Scene& scene, float direct, float indirect, float standard_error = 0) {
    auto bins = std::make_shared<Snapshot>();
    bins->photons = 1;
    const auto leaf = [&](float value) {
        const auto index = static_cast<std::uint32_t>(bins->leaves.size() / BREWSTER_LEAF_TEXELS);
        for (int corner = 0; corner < 4; ++corner)
            bins->leaves.emplace_back(value, value, value, corner < 3 ? standard_error : 0.0f);
        bins->nodes.push_back({0u, BREWSTER_NODE_LEAF | index});
        return static_cast<std::uint32_t>(bins->nodes.size() - 1);
    };
    for (std::size_t i = 0; i < scene.charts.size(); ++i) {
        const std::uint32_t direct_root = leaf(direct);
        bins->charts.push_back({direct_root, leaf(indirect), 1, 1});
    }
    return bins;
}

/// Bins of so many photons.
inline std::shared_ptr<const Snapshot> solved_bins(const std::shared_ptr<const Scene>& scene, std::uint64_t photons,
                                                   std::uint64_t seed = 1) {
    EngineSettings settings;
    settings.seed = seed;
    settings.threads = 2;
    Engine engine(scene, settings);
    engine.start({photons, {}, {}});
    engine.wait();
    return engine.snapshot();
}

inline std::shared_ptr<const Scene> scene_of_assets(const std::string& name) {
    return std::make_shared<const Scene>(read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/" + name + ".gltf"));
}

/// A picture of so many draws for each pixel.
inline StokesPicture gathered(const std::shared_ptr<const Scene>& scene, std::shared_ptr<const Snapshot> bins,
                              const Camera& camera, int width, int height, std::uint32_t draws,
                              std::uint64_t seed = 1) {
    Gather gather(std::make_shared<EyeScene>(*scene), seed);
    gather.show(std::move(bins));
    gather.look(camera, width, height);
    gather.draw(draws, 2, never);
    return gather.picture();
}

/// What independent draws of the eye through one pixel see: unpolarized radiance of the first band, or a Stokes component
/// of the polarized world. `how`: all but their numbers and place.
inline std::vector<double> independent_looks(const std::shared_ptr<const Scene>& scene, const Snapshot& bins,
                                             const Camera& camera, const Draw& how, std::uint32_t batches = 1,
                                             std::optional<std::size_t> component = {}) {
    const EyeScene eye_scene(*scene);
    EyeTracer tracer;
    const auto seen = std::make_unique<LevelLight>();
    std::vector<double> radiance;
    for (std::uint32_t batch = 0; batch < batches; ++batch) {
        std::vector<Draw> draws(eye_batch, how);
        for (std::uint32_t k = 0; k < eye_batch; ++k)
            draws[k].numbers = {sequence_key(batch + 1, k, 0), 0};  // a sequence of its own: independent
        tracer.trace(eye_scene, bins, camera, 1, 1, draws, *seen);
        const bool both = eye_scene.components > 1 && !component;
        const auto& from = both ? seen->unpolarized[0] : seen->stokes[3 * component.value_or(0)];
        radiance.insert(radiance.end(), from.begin(), from.begin() + eye_batch);
    }
    return radiance;
}

/// Mean of one value, over a picture or of independent draws, and its standard error.
struct PlaneMean {
    double mean = 0, error = 0;
};

inline PlaneMean mean_of(const std::vector<double>& seen) {
    double sum = 0, squares = 0;
    for (const double x : seen) {
        sum += x;
        squares += x * x;
    }
    const auto n = static_cast<double>(seen.size());
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / n)};
}

inline PlaneMean mean_of(const StokesPicture& picture, Plane plane, int band = 0) {
    PlaneMean result;
    double variance = 0;
    for (std::size_t p = 0; p < picture.pixel_count(); ++p) {
        result.mean += static_cast<double>(picture.of(plane)[p][band]);
        variance += static_cast<double>(picture.variance_of(plane)[p][band]);
    }
    const auto count = static_cast<double>(picture.pixel_count());
    return {result.mean / count, std::sqrt(variance) / count};
}

}  // namespace brewster
