#include "transport/thesis/thesis_tracer.h"

#include <algorithm>
#include <string>

#include "base/check.h"
#include "transport/scalar/trace_photon.h"
#include "transport/thesis/thesis_gloss.h"

namespace brewster {
namespace transport {
namespace {

constexpr int bands = band_count;
constexpr std::uint32_t first_free_draw = 16;  // beyond those of lobes that an arrival files
// Darker bases count their light as if they were as bright as this, because tallies hold no larger weights.
constexpr float rarest_count = 1 / 512.0f;

template <int components>
class ThesisTracer : public PhotonTracer {
    using Light = PhotonLight<float, components, bands>;
    using Going = Flight<float, components, bands>;

  public:
    explicit ThesisTracer(const ThesisRules& rules) : rules_(rules) {}

    void trace(const TransportContext& context, std::uint64_t begin, std::uint64_t end, WorkerSums& sums) override {
        for (std::uint64_t photon = begin; photon < end; ++photon) {
            Books<float> books;
            const auto replica = static_cast<std::uint32_t>(photon % replica_count);
            const auto meet = [&](const Hit& hit, const Meeting<float>& at, Going& flight) {
                return rules_.analog ? live_or_die(context, hit, at, flight, books, replica, sums)
                                     : file_and_go_on(context, hit, at, flight, books, replica, sums);
            };
            trace_photon<components, bands, true>(context, photon, books, sums, meet);
            books.close(sums.ledger);
        }
    }

  private:
    Sample<float, bands> sample_of(const TransportContext& context, const Meeting<float>& at, const Going& flight,
                                   const Event<float, bands>& event) const {
        const Sample<float, bands> sample = way_on(at, flight, event);
        if (!rules_.sampler) return sample;
        return thesis_scattered<bands>(*at.material, surface_point(at, flight.direction, flight.light), sample,
                                       lobe_numbers<float>(context, flight.key, first_free_draw));
    }

    static std::uint32_t gloss_chart(const TransportContext& context, const Meeting<float>& at) {
        return context.bins.gloss_charts.index[at.chart];
    }

    static void file_gloss(const TransportContext& context, const Meeting<float>& at, const Vector<float>& direction,
                           const Light& light, const Sample<float, bands>& sample, float share, std::uint32_t replica,
                           Tally<4>& tally) {
        const std::uint32_t chart = gloss_chart(context, at);
        const bool coarse = context.bins.gloss_charts.coarse[chart];
        const auto gloss = gloss_light(at, gloss_frame(at, direction), light, sample, coarse, share);
        if (!gloss.filed) return;
        const BinTree<4>::Point place = {at.u, at.v, gloss.square[0], gloss.square[1]};
        file_event<4>(context.bins.gloss, tally, context.bins.gloss.locate(chart, place), place,
                      {0, 0, gloss.weights, replica});
    }

    static void file_entry(const TransportContext& context, const Hit& hit, const Meeting<float>& at,
                           const Going& arrived, float factor, std::uint32_t replica, Tally<2>& tally) {
        Going counted = arrived;
        counted.light.scale(factor);
        deposit_entry<components, bands>(context, hit, at, counted, replica, tally);
    }

    /// The engine's way with the thesis's sampler: expected values are filed, several directions of gloss among them.
    bool file_and_go_on(const TransportContext& context, const Hit& hit, const Meeting<float>& at, Going& flight,
                        Books<float>& books, std::uint32_t replica, WorkerSums& sums) const {
        const bool glossy_chart = gloss_chart(context, at) != no_chart;
        const Event<float, bands> event = event_at(context, at, flight);
        if (at.material->diffuse()) file_entry(context, hit, at, flight, 1, replica, sums.entry);
        if (glossy_chart && !drawn_by_thesis(*at.material)) {
            deposit_gloss<components, bands>(context, at, flight, event, replica, sums.gloss);
        } else if (glossy_chart) {
            const bool coarse = context.bins.gloss_charts.coarse[gloss_chart(context, at)];
            const std::uint32_t count = deposits_of(*at.material, coarse);
            for (std::uint32_t k = 0; k < count; ++k) {
                const auto sample =
                    thesis_gloss<bands>(*at.material, surface_point(at, flight.direction, flight.light),
                                        k == 0 ? event.numbers.scatter : lobe_numbers<float>(context, flight.key, k));
                file_gloss(context, at, flight.direction, flight.light, sample, 1 / static_cast<float>(count), replica,
                           sums.gloss);
            }
        }
        scatter(context, at, sample_of(context, at, flight, event), flight, books, sums.counts);
        roulette(event.numbers.roulette, roulette_share, flight, books);
        grow_older(flight, books);
        return at.material->diffuse() || glossy_chart;
    }

    /// A photon is counted where it lives on, and by what sends it on: as many times more as it lives seldom.
    bool live_or_die(const TransportContext& context, const Hit& hit, const Meeting<float>& at, Going& flight,
                     Books<float>& books, std::uint32_t replica, WorkerSums& sums) const {
        const Going arrived = flight;
        const Event<float, bands> event = event_at(context, at, flight);
        const Sample<float, bands> sample = sample_of(context, at, flight, event);
        scatter(context, at, sample, flight, books, sums.counts);
        const float survival = std::min(flight.light.largest() / flight.reference, 1.0f);
        roulette(event.numbers.roulette, 1, flight, books);
        const bool lives = flight.alive && survival > 0;
        grow_older(flight, books);
        if (!lives) return false;
        if (sample.base) {
            const float chosen = bsdf_detail::base_probability<static_cast<std::size_t>(bands)>(
                *at.material, dot(-arrived.direction, at.shading_normal));
            file_entry(context, hit, at, arrived, 1 / std::max(survival * chosen, rarest_count), replica, sums.entry);
            return true;
        }
        if (gloss_chart(context, at) == no_chart) return false;
        file_gloss(context, at, arrived.direction, arrived.light, sample, 1 / std::max(survival, rarest_count), replica,
                   sums.gloss);
        return true;
    }

    const ThesisRules rules_;
};

}  // namespace
}  // namespace transport

std::unique_ptr<PhotonTracer> make_thesis_tracer(const KernelChoice& choice, const ThesisRules& rules) {
    BREWSTER_CHECK(choice.bands == band_count && (choice.stokes == 1 || choice.stokes == 4),
                   std::to_string(choice.stokes) + " " + std::to_string(choice.bands));
    if (choice.stokes == 1) return std::make_unique<transport::ThesisTracer<1>>(rules);
    return std::make_unique<transport::ThesisTracer<4>>(rules);
}

}  // namespace brewster
