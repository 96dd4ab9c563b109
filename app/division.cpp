#include "app/division.h"

#include <cmath>
#include <string>

#include "base/check.h"

namespace brewster {
namespace {

constexpr double photon_power = 0.6, draw_power = 1.2;
constexpr double shortest = 1e-6, longest = 1e12;  // seconds
constexpr int halvings = 60;

/// Squared error after `seconds`; where none is left there is none at any time.
double after(const Effort& effort, double power, double seconds) {
    return effort.error > 0 ? effort.error * std::pow(seconds / effort.seconds, -power) : 0;
}

/// How fast it falls.
double slope(const Effort& effort, double power, double seconds) {
    return power * after(effort, power, seconds) / seconds;
}

}  // namespace

double expected_error(const Effort& photons, const Effort& draws, const Division& division) {
    return after(photons, photon_power, division.photons) + after(draws, draw_power, division.draws);
}

Division divided(const Effort& photons, const Effort& draws, double seconds) {
    BREWSTER_CHECK(photons.seconds > 0 && draws.seconds > 0 && seconds > 0, std::to_string(seconds));
    double low = 0, high = seconds;  // photons are still the better use at low, no longer at high
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (low + high);
        const bool more = slope(photons, photon_power, middle) > slope(draws, draw_power, seconds - middle);
        (more ? low : high) = middle;
    }
    return {low, seconds - low};
}

Division division_to(const Effort& photons, const Effort& draws, double target) {
    BREWSTER_CHECK(target > 0, std::to_string(target));
    double low = shortest, high = longest;
    for (int k = 0; k < halvings; ++k) {
        const double middle = std::sqrt(low * high);
        const bool enough = expected_error(photons, draws, divided(photons, draws, middle)) <= target;
        (enough ? high : low) = middle;
    }
    return divided(photons, draws, high);
}

}  // namespace brewster
