#include "reference/reference.h"

#include <algorithm>
#include <chrono>

#include "app/interrupt.h"
#include "app/numbers.h"
#include "app/output.h"
#include "app/pictures.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "base/error.h"
#include "base/log.h"
#include "base/threads.h"
#include "image/exr.h"

namespace brewster {
namespace {

/// Adds samples until the first stop is reached: a few at a time, so that a passage takes about half a second, and at
/// least one. What comes out depends on their number alone. Returns the seconds it took.
double trace(Reference& reference, const ReferenceOptions& options) {
    using Clock = std::chrono::steady_clock;
    constexpr double seconds_a_passage = 0.5;
    const InterruptScope ctrl_c;
    const auto start = Clock::now();
    const std::uint64_t wanted = options.spp ? *options.spp : options.seconds ? UINT64_MAX : default_reference_samples;
    double elapsed = 0;
    while (reference.samples() < wanted && !ctrl_c.interrupted()) {
        double passage = seconds_a_passage;
        if (options.seconds) passage = std::min(passage, *options.seconds - elapsed);
        if (passage <= 0) break;
        const double rate = elapsed > 0 ? static_cast<double>(reference.samples()) / elapsed : 0;
        const auto affordable = static_cast<std::uint64_t>(std::clamp(passage * rate, 1.0, 1e6));
        reference.add_samples(std::min(affordable, wanted - reference.samples()));
        elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    }
    if (ctrl_c.interrupted())
        log_warning("stopped by a signal; going on with " + std::to_string(reference.samples()) + " samples a pixel");
    return elapsed;
}

std::string summary(const ReferenceResult& result) {
    std::string text = result.path + ": " + std::to_string(result.samples) + " samples a pixel";
    if (result.photons > 0) text += ", " + with_magnitude(static_cast<double>(result.photons)) + " photons";
    text += " in " + significant(result.seconds) + " s\n  mean radiance";
    for (const PictureMean& band : result.mean)
        text += " " + significant(band.mean, 5) + " +- " + significant(band.standard_error, 2);
    return text + " cd/m2\n";
}

}  // namespace

void make_reference(const ReferenceOptions& options) {
    if (options.json) log_only_warnings();
    const auto scene = load_scene(options.scene, options.settings);
    const Camera& camera = options.camera.empty() ? scene->cameras.front() : scene->camera(options.camera);
    if (!is_exr(options.out)) throw Error("it is no EXR picture", options.out, "give --out a name that ends in .exr");
    if (scene->lamps.empty()) throw Error("it has no lamp", scene->name, "add a lamp or a material that emits");
    prepare_folders({{camera.name, Map::radiance, options.out}});
    const unsigned threads = thread_count(options.threads);
    const PictureSize size = size_for(camera, options.size);

    Reference reference(*scene, camera, size.width, size.height, options.polarized, options.seed, threads);
    ReferenceResult result;
    result.seconds = trace(reference, options);
    if (reference.samples() == 0) throw Error("no path was traced", scene->name, "give it more time with --seconds");
    Image picture = reference.picture();
    for (std::size_t band = 0; band < result.mean.size(); ++band)
        result.mean[band] = mean_of(picture, 0, static_cast<int>(band));
    result.scene = scene->name;
    result.camera = camera.name;
    result.path = options.out;
    result.polarized = options.polarized;
    result.seed = options.seed;
    result.samples = reference.samples();
    result.photons = reference.photons();
    picture.attributes = {{"brewster.scene", result.scene},
                          {"brewster.camera", result.camera},
                          {"brewster.polarization", result.polarized ? "on" : "off"},
                          {"brewster.samples", std::to_string(result.samples)},
                          {"brewster.photons", std::to_string(result.photons)},
                          {"brewster.seed", std::to_string(result.seed)}};
    write_stokes_exr(options.out, picture);
    print_result(options.json ? reference_report(result) : summary(result));
}

}  // namespace brewster
