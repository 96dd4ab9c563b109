#include "transport/scalar/path_class_flux.h"

#include <span>

#include "base/check.h"
#include "base/paired_ratio.h"
#include "transport/scalar/trace_photon.h"

namespace brewster {
namespace {

using namespace transport;
using FullFlight = Flight<float, 4, band_count>;

// The light that arrives at the end of the class; nothing where the photon goes another way.
bool arrives(const TransportContext& context, const std::vector<std::vector<bool>>& allowed, std::uint64_t photon,
             FullFlight& flight) {
    const EmittedPhoton<float> emitted = context.emission.sample(photon);
    Ray ray = first_ray(emitted);
    ray.meets_holes = false;
    flight.direction = float_vector(ray.direction);
    flight.light = emitted_light<4, band_count>(context.scene, context.emission, emitted);
    flight.reference = flight.light.largest();
    flight.key = {static_cast<std::uint32_t>(photon), static_cast<std::uint32_t>(photon >> 32), 0};
    flight.alive = flight.direct = true;
    Books<float> books;
    TransportCounts counts;
    for (const std::vector<bool>& charts : allowed) {
        Hit hit;
        context.rays.intersect(std::span(&ray, 1), std::span(&hit, 1));
        if (hit.chart == no_chart || !charts[hit.chart]) return false;
        const Meeting<float> at = meeting_of(context, hit);
        cut_turned_away(at, flight, books);
        if (&charts == &allowed.back()) return flight.alive;
        if (flight.alive) go_on(context, at, event_at(context, at, flight), flight, books, counts);
        if (!flight.alive) return false;
        ++flight.key.bounce;
        ray = {hit.position, glm_vector(flight.direction), hit.triangle};
    }
    return false;
}

}  // namespace

PathClassFlux path_class_flux(const TransportContext& context, const std::vector<std::string>& meshes,
                              std::uint64_t count) {
    BREWSTER_CHECK(!meshes.empty() && count > 0, std::to_string(count));
    std::vector<std::vector<bool>> allowed;
    for (const std::string& mesh : meshes) allowed.push_back(context.scene.is_of(mesh));
    PathClassFlux flux;
    PairedRatio ratio;
    for (std::uint64_t photon = 0; photon < count; ++photon) {
        FullFlight flight;
        if (!arrives(context, allowed, photon, flight)) continue;
        double polarized = 0, unpolarized = 0;
        for (std::size_t band = 0; band < band_count; ++band) {
            const auto with = static_cast<double>(flight.light.power(0, static_cast<int>(band)));
            const auto without = static_cast<double>(flight.light.power(1, static_cast<int>(band)));
            flux.polarized[band] += with / static_cast<double>(count);
            flux.unpolarized[band] += without / static_cast<double>(count);
            polarized += with;
            unpolarized += without;
        }
        ratio.add(polarized, unpolarized);
    }
    flux.ratio = ratio.value();
    flux.ratio_standard_error = ratio.standard_error();
    return flux;
}

}  // namespace brewster
