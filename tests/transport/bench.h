#pragma once
#include <vector>

#include "transport/kernel.h"

namespace brewster {

/// A scene with one tally cell a chart, and photons traced into it.
struct Bench {
    explicit Bench(const Scene& scene_in, std::uint64_t seed = 1, const KernelChoice& kernel = {1, 3, false})
        : scene(scene_in),
          rays(scene),
          emission(scene, seed),
          materials(prepare_materials(scene.materials)),
          bins(outlines(scene), gloss_charts_of(scene, materials), {kernel.bands, 1, kernel.stokes > 1 ? 2 : 1},
               {kernel.bands, kernel.stokes}, one_cell()),
          context{scene, rays, emission, materials, bins, seed, !scene.textures.empty()},
          tracer(make_tracer(kernel)),
          sums(bins) {
        sums.fit(bins, emission.guide());
    }
    static BinSettings one_cell() {
        BinSettings settings;
        settings.fixed_grid_log2 = 0;
        return settings;
    }
    static std::vector<Outline> outlines(const Scene& scene) {
        std::vector<Outline> all(scene.charts.size());
        for (Outline& outline : all) {
            outline.triangles = {{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1)},
                                 {glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}};
        }
        return all;
    }
    void trace(std::uint64_t begin, std::uint64_t end) {
        tracer->trace(context, begin, end, sums);
    }
    // Flux into a chart's base in lumen, one band.
    double flux(std::uint32_t chart, bool direct, std::size_t band) const {
        const std::size_t channel = (direct ? 0 : band_count) + band;  // of the polarized world
        const Quanta* row =
            sums.entry.estimate(bins.entry.node(chart).leaf()) + channel * RecordLayout<2>::estimate_stride;
        return to_weight(*row) * emission.mean_power() / static_cast<double>(sums.counts.photons);
    }
    const Scene& scene;
    Rays rays;
    PhotonEmission emission;
    std::vector<PreparedMaterial> materials;
    Bins bins;
    TransportContext context;
    std::unique_ptr<PhotonTracer> tracer;
    WorkerSums sums;
};

}  // namespace brewster
