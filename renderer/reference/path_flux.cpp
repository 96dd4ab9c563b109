#include "reference/path_flux.h"

#include <cmath>

#include "base/check.h"
#include "reference/light_path.h"
#include "reference/ordered_blocks.h"

namespace brewster {
namespace {

struct BlockSums {
    std::array<double, band_count> on{}, off{}, on_squares{}, off_squares{};
    double on_on = 0, on_off = 0, off_off = 0;  // of the photons' sums over bands
};

void add(BlockSums& to, const BlockSums& from) {
    for (std::size_t band = 0; band < band_count; ++band) {
        to.on[band] += from.on[band];
        to.off[band] += from.off[band];
        to.on_squares[band] += from.on_squares[band];
        to.off_squares[band] += from.off_squares[band];
    }
    to.on_on += from.on_on;
    to.on_off += from.on_off;
    to.off_off += from.off_off;
}

std::vector<std::vector<bool>> charts_of(const Scene& scene, const std::vector<std::string>& meshes) {
    std::vector<std::vector<bool>> allowed;
    for (const std::string& mesh : meshes) {
        allowed.emplace_back(scene.charts.size(), false);
        for (const std::uint32_t chart : scene.charts_of(mesh)) allowed.back()[chart] = true;
    }
    return allowed;
}

}  // namespace

PathFlux path_flux(const Surroundings& surroundings, const std::vector<std::string>& meshes, std::uint64_t photons,
                   std::uint64_t seed, unsigned threads) {
    BREWSTER_CHECK(!meshes.empty() && photons > 0, std::to_string(photons));
    const std::vector<std::vector<bool>> allowed = charts_of(surroundings.scene, meshes);
    const PhotonSource source(surroundings);
    BlockSums sums;
    if (!source.any()) return {};

    const auto follow = [&](std::uint64_t index, BlockSums& to) {
        const PathRandom random(seed, index, PathRandom::Kind::light);
        Photon<4> on = source.emit<4>(random);
        Photon<1> off = source.emit<1>(random);
        for (std::uint32_t step = 0;; ++step) {
            const auto met = surroundings.meet(on.position, on.direction, on.leaving);
            if (!met.vertex || !allowed[step][met.vertex->chart]) return;
            if (step + 1 == meshes.size()) break;
            // The state has no say in where a photon goes, so both stay together.
            const BounceNumbers numbers(random, step + 1, met.vertex->material->rough());
            const auto with = scatter(on, *met.vertex, numbers), without = scatter(off, *met.vertex, numbers);
            if (!with && !without) return;
        }
        double on_sum = 0, off_sum = 0;
        for (std::size_t band = 0; band < band_count; ++band) {
            const double x = on.light[band].s0(), y = off.light[band].s0();
            to.on[band] += x;
            to.off[band] += y;
            to.on_squares[band] += x * x;
            to.off_squares[band] += y * y;
            on_sum += x;
            off_sum += y;
        }
        to.on_on += on_sum * on_sum;
        to.on_off += on_sum * off_sum;
        to.off_off += off_sum * off_sum;
    };
    in_ordered_blocks(
        0, photons, 1u << 14, threads,
        [&](std::uint64_t first, std::uint64_t end) {
            BlockSums block;
            for (std::uint64_t index = first; index < end; ++index) follow(index, block);
            return block;
        },
        [&](const BlockSums& block) { add(sums, block); });

    PathFlux flux;
    const auto n = static_cast<double>(photons);
    double on = 0, off = 0;
    const auto error = [&](double mean, double squares) { return std::sqrt((squares / n - mean * mean) / n); };
    for (std::size_t band = 0; band < band_count; ++band) {
        flux.polarized.mean[band] = sums.on[band] / n;
        flux.unpolarized.mean[band] = sums.off[band] / n;
        flux.polarized.standard_error[band] = error(flux.polarized.mean[band], sums.on_squares[band]);
        flux.unpolarized.standard_error[band] = error(flux.unpolarized.mean[band], sums.off_squares[band]);
        on += sums.on[band];
        off += sums.off[band];
    }
    if (off > 0) {
        // Delta method: variance of sum (x - ratio y) over that of the denominator.
        flux.ratio = on / off;
        const double spread = sums.on_on - 2 * flux.ratio * sums.on_off + flux.ratio * flux.ratio * sums.off_off;
        flux.ratio_standard_error = std::sqrt(std::max(spread, 0.0)) / off;
    }
    return flux;
}

}  // namespace brewster
