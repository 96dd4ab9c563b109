#include "app/divided_trace.h"

#include <algorithm>

#include "app/clock.h"
#include "app/trace.h"

namespace brewster {
namespace {

// Of the seconds, for the first look. Less were enough for that; but what cells are too wide for, contact shadows above
// all, is in no error bar that photons and draws are weighed by, and only photons mend it.
constexpr double first_share = 0.3;
constexpr double first_seconds = 0.25;  // for it where no seconds are asked for
constexpr double farthest = 4;          // times the photons so far: what they tell does not reach farther
constexpr double worthwhile = 0.1;      // of the photons so far; fewer more are not begun, or not alone
constexpr double aim = 0.9;             // of the squared target: trial pictures are not the pictures
constexpr int samples_in_time = 1 << 20;

/// Whether another look may follow: traces for so many seconds, or to the last photon asked for.
bool trace_seconds(Engine& engine, double seconds, const StopRule& asked, bool& interrupted) {
    StopRule rule;
    rule.seconds = seconds;
    if (asked.photons) rule.photons = *asked.photons - engine.progress().photons;
    interrupted = !trace_on(engine, rule);
    return !interrupted && !(asked.photons && engine.progress().photons >= *asked.photons);
}

}  // namespace

DrawRule trace_for_pictures(Engine& engine, EyePictures& eye, std::span<const Camera* const> cameras,
                            const ShotOptions& options) {
    const StopRule& asked = options.solve.stop;
    DrawRule rule;
    if (!asked.seconds && !asked.target_error) {
        trace(engine, asked);
        rule.samples = options.samples.value_or(default_samples);
        return rule;
    }
    rule.samples = options.samples.value_or(samples_in_time);
    const double begin = seconds_now();
    if (asked.seconds) rule.end = begin + *asked.seconds;
    if (asked.target_error) rule.target_error = *asked.target_error * *asked.target_error;

    double more = asked.seconds ? first_share * *asked.seconds : first_seconds;
    bool interrupted = false;
    while (trace_seconds(engine, more, asked, interrupted)) {
        const EyePictures::Trial trial = eye.trial(engine.snapshot(), cameras);
        const Effort photons{engine.progress().seconds, trial.bins_error};
        std::optional<Division> plan;
        if (asked.target_error && photons.error + trial.draws.error > 0)
            plan = division_to(photons, trial.draws, aim * *rule.target_error);
        if (asked.seconds) {
            const double left = rule.end - seconds_now();
            if (left <= 0) break;
            const Division in_time = divided(photons, trial.draws, photons.seconds + left);
            if (!plan || plan->total() > in_time.total()) plan = in_time;
        }
        if (!plan) break;
        more = std::min(plan->photons, farthest * photons.seconds) - photons.seconds;
        const double least = worthwhile * photons.seconds;
        if (more <= (asked.target_error ? 0 : least)) break;
        more = std::max(more, least);
    }
    finish_trace(engine, interrupted);
    return rule;
}

}  // namespace brewster
