#include "reference/path_flux.h"

#include <cmath>

#include "base/check.h"
#include "base/paired_ratio.h"
#include "reference/light_path.h"
#include "reference/ordered_blocks.h"

namespace brewster {
namespace {

struct BlockSums {
    std::array<double, band_count> on{}, off{}, on_squares{}, off_squares{};
    PairedRatio ratio;  // of the photons' sums over bands
};

void add(BlockSums& to, const BlockSums& from) {
    for (std::size_t band = 0; band < band_count; ++band) {
        to.on[band] += from.on[band];
        to.off[band] += from.off[band];
        to.on_squares[band] += from.on_squares[band];
        to.off_squares[band] += from.off_squares[band];
    }
    to.ratio.add(from.ratio);
}

}  // namespace

PathFlux path_flux(const Surroundings& surroundings, const std::vector<std::string>& meshes, std::uint64_t photons,
                   std::uint64_t seed, unsigned threads) {
    BREWSTER_CHECK(!meshes.empty() && photons > 0, std::to_string(photons));
    std::vector<std::vector<bool>> allowed;
    for (const std::string& mesh : meshes) allowed.push_back(surroundings.scene.is_of(mesh));
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
        to.ratio.add(on_sum, off_sum);
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
    const auto error = [&](double mean, double squares) { return std::sqrt((squares / n - mean * mean) / n); };
    for (std::size_t band = 0; band < band_count; ++band) {
        flux.polarized.mean[band] = sums.on[band] / n;
        flux.unpolarized.mean[band] = sums.off[band] / n;
        flux.polarized.standard_error[band] = error(flux.polarized.mean[band], sums.on_squares[band]);
        flux.unpolarized.standard_error[band] = error(flux.unpolarized.mean[band], sums.off_squares[band]);
    }
    flux.ratio = sums.ratio.value();
    flux.ratio_standard_error = sums.ratio.standard_error();
    return flux;
}

}  // namespace brewster
