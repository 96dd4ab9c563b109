#include "app/trace.h"

#include <unistd.h>

#include <cstdio>

#include "app/faint_lamps.h"
#include "app/interrupt.h"
#include "app/progress_line.h"
#include "base/error.h"
#include "base/log.h"
#include "embedded_app.h"
#include "engine/saved_settings.h"

namespace brewster {
namespace {

std::vector<Setting> settings_from(const std::vector<std::string>& texts, const SolutionReader& file) {
    std::vector<Setting> settings;
    for (const std::string& text : texts) {
        const std::optional<Setting> setting = parse_setting(text);
        if (!setting) file.block("settings").refuse();
        settings.push_back(*setting);
    }
    return settings;
}

}  // namespace

std::shared_ptr<const Scene> load_scene(const std::string& path, const std::vector<Setting>& settings) {
    auto scene = std::make_shared<Scene>(path.empty() ? read_scene_text(embedded::default_scene(), "cornell-box")
                                                      : read_scene(path));
    apply_settings(*scene, settings);
    for (const std::string& warning : scene->warnings) log_warning(warning);
    return scene;
}

Solution saved_solution(const SolveOptions& options) {
    const SolutionReader file(options.resume);
    const SavedSettings saved = saved_settings(file);
    EngineSettings settings = saved.engine;
    settings.threads = options.engine.threads;
    settings.lowest_priority = options.engine.lowest_priority;
    settings.snapshot_seconds = options.engine.snapshot_seconds;
    std::shared_ptr<const Scene> scene;
    try {
        scene = load_scene(options.scene, settings_from(settings.changes, file));
    } catch (const Error& error) {
        if (settings.changes.empty()) throw;
        throw Error("it was traced in a scene called \"" + saved.scene_name +
                        "\", changed by --set, which fails here (" + error.what() + std::string(")"),
                    options.resume, "name the scene file that it was made of");
    }
    auto engine = std::make_unique<Engine>(scene, settings);
    engine->load(file);
    return {std::move(scene), std::move(engine)};
}

std::unique_ptr<Engine> engine_for(const SolveOptions& options) {
    if (!options.resume.empty()) return saved_solution(options).engine;
    EngineSettings settings = options.engine;
    for (const Setting& setting : options.settings) settings.changes.push_back(setting_text(setting));
    return std::make_unique<Engine>(load_scene(options.scene, options.settings), settings);
}

bool trace_on(Engine& engine, const StopRule& wished) {
    StopRule rule = wished;
    const Progress before = engine.progress();
    if (rule.photons) *rule.photons += before.photons;
    if (rule.seconds) *rule.seconds += before.seconds;
    constexpr double seconds_between_looks = 0.1;
    constexpr const char* clear_line = "\r\x1b[K";
    const bool on_terminal = isatty(STDERR_FILENO) == 1;

    const InterruptScope ctrl_c;
    engine.start(rule);
    while (!engine.wait_for(seconds_between_looks)) {
        if (on_terminal) std::fprintf(stderr, "%s%s", clear_line, progress_line(engine.progress(), rule).c_str());
        if (ctrl_c.interrupted()) {
            engine.stop();
            break;
        }
    }
    if (on_terminal) std::fputs(clear_line, stderr);
    engine.wait();
    return !ctrl_c.interrupted();
}

void finish_trace(const Engine& engine, bool interrupted) {
    const std::uint64_t photons = engine.progress().photons;
    if (photons == 0) {
        throw Error("no photon was traced", engine.scene().name, "give it more time with --photons or --seconds");
    }
    for (const std::string& lamp : faint_lamps(engine.scene(), static_cast<double>(photons)))
        log_warning("lamp \"" + lamp + "\" is too faint for " + std::to_string(photons) +
                    " photons; what it lights alone stays dark");
    if (interrupted) log_warning("stopped by a signal; going on with " + std::to_string(photons) + " photons");
}

void trace(Engine& engine, const StopRule& wished) {
    StopRule rule = wished;
    if (!rule.photons && !rule.seconds && !rule.target_error) rule.photons = default_photons;
    const bool whole = trace_on(engine, rule);
    finish_trace(engine, !whole);
}

}  // namespace brewster
