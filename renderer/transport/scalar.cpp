#include "transport/scalar.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <span>

#include "base/philox.h"
#include "scene/albedo.h"
#include "scene/lamp.h"
#include "transport/deposit.h"

namespace brewster {
namespace {

constexpr std::uint32_t bounce_limit = 1u << 16;  // no room is this bright; what is left there is booked as cut
constexpr float roulette_share = 0.25f;           // of the weight at emission, below which the roulette begins

float largest(const glm::vec3& weight) {
    return std::max(weight.x, std::max(weight.y, weight.z));
}

bool finite(const glm::vec3& weight) {
    return std::isfinite(weight.x + weight.y + weight.z);
}

void book(Ledger::Account& account, const glm::vec3& weight) {
    for (int band = 0; band < band_count; ++band) account[static_cast<std::size_t>(band)] += to_quanta(weight[band]);
}

// What an event took, in the quanta of before less those of after, so that the accounts add up exactly.
void book(Ledger::Account& account, const glm::vec3& before, const glm::vec3& after) {
    for (int band = 0; band < band_count; ++band)
        account[static_cast<std::size_t>(band)] += to_quanta(before[band]) - to_quanta(after[band]);
}

}  // namespace

void TransportCounts::add(const TransportCounts& other) {
    photons += other.photons;
    useful += other.useful;
    bounces += other.bounces;
    rays += other.rays;
    trouble += other.trouble;
}

void ScalarTransport::trace(std::uint64_t photon, WorkerSums& sums) const {
    const auto replica = static_cast<std::uint32_t>(photon % replica_count);
    const EmittedPhoton emitted = emission_.sample(photon);
    Ray ray = emitted.ray;
    glm::vec3 weight = emitted.weight;
    const float reference = largest(weight);
    ++sums.counts.photons;
    book(sums.ledger.emitted, weight);
    bool direct = true, useful = false;

    for (std::uint32_t bounce = 0; bounce < bounce_limit; ++bounce) {
        Hit hit;
        ray.meets_holes = true;
        rays_.intersect(std::span(&ray, 1), std::span(&hit, 1));
        ++sums.counts.rays;
        if (hit.escaped()) {
            book(sums.ledger.escaped, weight);
            return;
        }
        if (hit.hole) {
            // Light passes, and is filed as if the surface went on there: cells need not know how much of them is cut.
            if (hit.chart != no_chart) deposit(tree_, {}, sums.bins, hit, std::span(&weight.x, 3), direct, replica);
            ray.origin = hit.position;
            ray.leaving = hit.triangle;
            continue;
        }
        ++sums.counts.bounces;
        if (hit.chart == no_chart) {
            book(sums.ledger.absorbed, weight);
            return;
        }
        if (!useful) ++sums.counts.useful;
        useful = true;
        deposit(tree_, {}, sums.bins, hit, std::span(&weight.x, 3), direct, replica);

        const Chart& chart = scene_.charts[hit.chart];
        const glm::vec3 reflected = weight * nearest_lambert_at(scene_, hit);
        if (!finite(reflected)) {
            ++sums.counts.trouble;
            book(sums.ledger.cut, weight);
            return;
        }
        book(sums.ledger.absorbed, weight, reflected);
        weight = reflected;

        const std::array<std::uint32_t, 4> random = philox(seed_, photon, bounce, 0);
        const float left = largest(weight);
        if (left < roulette_share * reference) {
            const float survival = left / reference;
            if (!(unit_float(random[0]) < survival)) {
                book(sums.ledger.roulette, weight);
                return;
            }
            const glm::vec3 raised = weight / survival;
            book(sums.ledger.roulette, weight, raised);
            weight = raised;
        }

        const float xi_radius = direct ? emission_.sobol(photon, PhotonEmission::dimensions) : unit_float(random[1]);
        const float xi_turn = direct ? emission_.sobol(photon, PhotonEmission::dimensions + 1) : unit_float(random[2]);
        ray.origin = hit.position;
        ray.direction = sample_cosine(chart.axis_u, chart.axis_v, chart.normal, xi_radius, xi_turn);
        ray.leaving = hit.triangle;
        direct = false;
    }
    book(sums.ledger.cut, weight);
}

}  // namespace brewster
