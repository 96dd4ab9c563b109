#include "app/replay.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/clock.h"
#include "app/keys.h"
#include "app/output.h"
#include "base/error.h"

namespace brewster {
namespace {

using nlohmann::json;

double processor_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// What the process holds in memory.
double resident_mb() {
    std::ifstream file("/proc/self/statm");
    double whole = 0, resident = 0;
    file >> whole >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Button button_of(const json& step) {
    const std::string name = step.value("button", "left");
    return name == "middle" ? Button::middle : name == "right" ? Button::right : Button::left;
}

std::string name_of(Button button) {
    return button == Button::middle ? "middle" : button == Button::right ? "right" : "left";
}

/// "Ctrl+Shift+A" taken apart.
InputEvent event_of(std::string chord, InputEvent::Kind kind) {
    InputEvent event;
    event.kind = kind;
    const auto take = [&](const std::string& modifier) {
        if (!chord.starts_with(modifier) || chord.size() == modifier.size()) return false;
        chord.erase(0, modifier.size());
        return true;
    };
    event.control = take("Ctrl+");
    event.alt = take("Alt+");
    event.shift = take("Shift+");
    event.key = chord;
    return event;
}

/// A whole number of a script. Throws json's own exception, as for any other value of the wrong kind.
int whole(const json& value, int least, int most) {
    const auto number = value.get<double>();
    if (number >= least && number <= most) return static_cast<int>(number);
    throw json::other_error::create(
        501, value.dump() + " is no number from " + std::to_string(least) + " to " + std::to_string(most), &value);
}

bool holds(const json& wanted, const json& found, const json& remembered) {
    if (wanted.is_object() && !found.is_object()) {
        for (const auto& [sign, bound] : wanted.items()) {
            if (sign == "remembered") {
                if (bound != (found == remembered)) return false;
                continue;
            }
            if (sign == "not") {
                if (bound == found) return false;
                continue;
            }
            const double a = found.is_number() ? found.get<double>() : NAN, b = bound.get<double>();
            if (!(sign == ">" ? a > b : sign == "<" ? a < b : sign == ">=" ? a >= b : sign == "<=" && a <= b))
                return false;
        }
        return true;
    }
    return wanted == found;
}

/// The fields of `wanted` that are not so, in words; empty when all are.
std::string complaint(const json& wanted, const json& state, const json& remembered) {
    std::string text;
    for (const auto& [name, value] : wanted.items()) {
        const json found = state.value(name, json());
        if (!holds(value, found, remembered.value(name, json())))
            text += name + " is " + found.dump() + ", not " + value.dump() + "; ";
    }
    return text;
}

}  // namespace

struct Replay::Impl {
    json steps, report = {{"events", json::array()}, {"measures", json::object()}, {"failures", json::array()}};
    std::string path, report_path;
    double least_seconds = 0;
    std::size_t next = 0;
    double begin = seconds_now(), step_begin = 0;
    bool begun = false;
    std::uint64_t frames = 0;
    int moved = 0;  // of a drag
    glm::vec2 pointer{0.0f};

    // Of the step that runs.
    json remembered = json::object();
    std::uint64_t frames_before = 0, photons_before = 0;
    double processor_before = 0, measured_from = 0;
    std::uint64_t measured_frames = 0;
    std::vector<double> frame_ms;
    std::uint64_t bare_frames = 0;  // that lack light which bins cannot show
    double longest_turn_ms = 0;

    // Events of which the first frame that shows them is awaited.
    struct Asked {
        std::size_t index;
        double when;
        std::uint64_t frames;
        json state;
    };
    std::optional<Asked> asked;

    bool do_step(Stage& stage, const json& step);
    void script(Stage& stage, InputEvent event, glm::vec2 picture);
    void start_measure(const json& state);
    void end_measure(const std::string& name, const json& state);
    void finish();
};

Replay::Replay(const std::string& script, std::string report) : impl_(std::make_unique<Impl>()) {
    std::ifstream stream(script);
    try {
        const json script_text = json::parse(stream);
        impl_->steps = script_text.at("steps");
        impl_->least_seconds = script_text.value("seconds", 0.0);
        if (!impl_->steps.is_array()) throw Error("its steps are no list", script, "see the comment of Replay");
        for (const json& step : impl_->steps)
            if (!step.is_object())
                throw Error("it holds " + step.dump() + " for a step", script, "see the comment of Replay");
    } catch (const json::exception& error) {
        throw Error(std::string("it is no script: ") + error.what(), script, "see the comment of Replay");
    }
    impl_->path = script;
    impl_->report_path = std::move(report);
}

Replay::~Replay() = default;

double Replay::patience() const {
    constexpr double next_look = 0.01;
    if (!impl_->begun || impl_->next >= impl_->steps.size()) return 0;
    const json& step = impl_->steps[impl_->next];
    const auto number = [](const json& value) { return value.is_number() ? value.get<double>() : 0.0; };
    const double length = step.contains("wait")      ? number(step["wait"])
                          : step.contains("measure") ? number(step.value("seconds", json(1.0)))
                                                     : 0.0;
    return length > 0 ? std::max(0.0, impl_->step_begin + length - seconds_now()) : next_look;
}

bool Replay::failed() const {
    return !impl_->report["failures"].empty();
}

void Replay::Impl::script(Stage& stage, InputEvent event, glm::vec2 picture) {
    event.place = pointer * picture;
    stage.input(event);
}

// True when the step is done.
bool Replay::Impl::do_step(Stage& stage, const json& step) {
    using Kind = InputEvent::Kind;
    const json state = stage.state();
    const glm::vec2 picture(state["picture"][0], state["picture"][1]);
    const auto place = [](const json& at, std::size_t i = 0) { return glm::vec2(at.at(i), at.at(i + 1)); };
    const auto button_event = [&](Kind kind) {
        InputEvent event;
        event.kind = kind;
        event.button = button_of(step);
        event.shift = step.value("shift", false);
        event.control = step.value("control", false);
        return event;
    };
    const auto ask = [&] {
        report["events"].push_back({{"step", step}});
        asked = Asked{report["events"].size() - 1, seconds_now(), frames, state};
    };
    const double elapsed = seconds_now() - step_begin;
    if (step.contains("key")) {
        if (moved++ == 0) {
            ask();
            script(stage, event_of(step["key"], Kind::key_press), picture);
            script(stage, event_of(step["key"], Kind::key_release), picture);
        }
        return !asked;
    }
    if (step.contains("hold")) return script(stage, event_of(step["hold"], Kind::key_press), picture), true;
    if (step.contains("let_go")) return script(stage, event_of(step["let_go"], Kind::key_release), picture), true;
    if (step.contains("move")) {
        pointer = place(step["move"]);
        return script(stage, button_event(Kind::motion), picture), true;
    }
    if (step.contains("click")) {
        // A widget must have felt the pointer before it is pressed, and the press before the release.
        pointer = place(step["click"]);
        constexpr int gap = 3;
        if (moved % gap == 0)
            script(stage,
                   button_event(moved == 0     ? Kind::motion
                                : moved == gap ? Kind::button_press
                                               : Kind::button_release),
                   picture);
        return ++moved > 2 * gap;
    }
    if (step.contains("wheel")) {
        pointer = place(step.at("at"));
        InputEvent event = button_event(Kind::wheel);
        event.notches = step["wheel"];
        event.alt = step.value("alt", false);
        return script(stage, event, picture), true;
    }
    if (step.contains("drag")) {
        const int count = step.contains("frames") ? whole(step["frames"], 1, 1'000'000) : 20;
        const std::uint64_t seen = frames;
        if (moved > 0 && moved <= count && seen == frames_before) return elapsed > 30;  // one frame a motion
        frames_before = seen;
        const glm::vec2 from = place(step["drag"]), to = place(step["drag"], 2);
        pointer = from + (to - from) * (static_cast<float>(std::clamp(moved, 0, count)) / static_cast<float>(count));
        if (moved == 0) script(stage, button_event(Kind::motion), picture);
        script(stage,
               button_event(moved == 0       ? Kind::button_press
                            : moved <= count ? Kind::motion
                                             : Kind::button_release),
               picture);
        if (moved == 0) start_measure(state);
        if (moved++ <= count) return false;
        if (step.contains("measure")) end_measure(step["measure"], state);
        return true;
    }
    if (step.contains("event")) {
        if (elapsed < step.value("after", 0.0)) return false;
        const json& from = step["event"];
        constexpr int first = static_cast<int>(Kind::key_press), last = static_cast<int>(Kind::wheel);
        const auto kind = from.contains("kind") ? static_cast<Kind>(whole(from["kind"], first, last)) : Kind::motion;
        InputEvent event = event_of(from.value("key", ""), kind);
        event.button = button_of(from);
        event.shift = from.value("shift", false);
        event.control = from.value("control", false);
        event.alt = from.value("alt", false);
        event.repeat = from.value("repeat", false);
        event.notches = from.value("notches", 0.0f);
        pointer = place(from.at("at"));
        return script(stage, event, picture), true;
    }
    if (step.contains("set")) {
        if (moved++ == 0) {
            ask();
            stage.set(step["set"]);
        }
        return !asked;
    }
    if (step.contains("type")) return stage.type(step["type"]), true;
    if (step.contains("open")) return stage.open(step["open"]), true;
    if (step.contains("resize")) {
        constexpr int most = 1 << 15;
        return stage.resize(whole(step["resize"].at(0), 1, most), whole(step["resize"].at(1), 1, most)), true;
    }
    if (step.contains("minimise")) return stage.minimise(step["minimise"]), true;
    if (step.contains("flat")) return stage.make_flat(step["flat"]), true;
    if (step.contains("capture")) return stage.capture(step["capture"]), true;
    if (step.contains("save")) {
        if (moved++ == 0) {
            report["saved"].push_back({{"path", step["save"]}, {"words", state["words"]}});
            stage.save(step["save"]);
        }
        return !stage.state()["saving"].get<bool>();
    }
    if (step.contains("save_solution")) {
        if (moved++ == 0) stage.save_solution(step["save_solution"]);
        return !stage.state()["saving"].get<bool>();
    }
    if (step.contains("remember")) {
        for (const json& name : step["remember"]) remembered[name] = state.at(name);
        return true;
    }
    if (step.contains("wait")) return elapsed >= step["wait"].get<double>();
    if (step.contains("expect") || step.contains("until")) {
        const bool now = step.contains("expect");
        const bool measured = step.contains("measure");
        if (measured && moved++ == 0) start_measure(state);
        const std::string words = complaint(step[now ? "expect" : "until"], state, remembered);
        if (measured && words.empty()) end_measure(step["measure"], state);
        if (words.empty()) return true;
        if (!now && elapsed < step.value("seconds", 10.0)) return false;
        report["failures"].push_back({{"step", step}, {"what", words}});
        return true;
    }
    if (step.contains("measure")) {
        if (moved++ == 0) start_measure(state);
        if (elapsed < step.value("seconds", 1.0)) return false;
        return end_measure(step["measure"], state), true;
    }
    throw Error("it holds an unknown step " + step.dump(), path, "see the comment of Replay");
}

void Replay::Impl::start_measure(const json& state) {
    measured_from = seconds_now();
    measured_frames = frames;
    photons_before = state["photons"];
    processor_before = processor_seconds();
    frame_ms.clear();
    bare_frames = 0;
    longest_turn_ms = 0;
}

void Replay::Impl::end_measure(const std::string& name, const json& state) {
    const double elapsed = seconds_now() - measured_from;
    report["measures"][name] = {
        {"seconds", elapsed},
        {"frames", frames - measured_frames},
        {"frames_per_second", static_cast<double>(frames - measured_frames) / elapsed},
        {"frame_ms", median(frame_ms)},
        {"longest_frame_ms", frame_ms.empty() ? 0.0 : *std::max_element(frame_ms.begin(), frame_ms.end())},
        {"longest_turn_ms", longest_turn_ms},
        {"bare_frames", bare_frames},
        {"photons_per_second", (state["photons"].get<double>() - static_cast<double>(photons_before)) / elapsed},
        {"processor_share", (processor_seconds() - processor_before) / elapsed},
        {"state", state}};
}

bool Replay::advance(Stage& stage) {
    Impl& play = *impl_;
    while (play.next < play.steps.size()) {
        if (!play.begun) {
            play.begun = true;
            play.step_begin = seconds_now();
            play.moved = 0;
        }
        const json& step = play.steps[play.next];
        try {
            if (!play.do_step(stage, step)) return true;
        } catch (const json::exception& error) {
            throw Error("its step " + std::to_string(play.next + 1) + " cannot be played: " + error.what(), play.path,
                        "see the comment of Replay");
        }
        play.begun = false;
        ++play.next;
        // Whatever was done is to be handled before the next step looks.
        if (!step.contains("expect")) return true;
    }
    play.report["resident_mb"].push_back(resident_mb());
    if (seconds_now() - play.begin < play.least_seconds && play.report["failures"].empty()) {
        play.next = 0;
        return true;
    }
    play.report["state"] = stage.state();
    play.finish();
    return false;
}

void Replay::Impl::finish() {
    report["seconds"] = seconds_now() - begin;
    report["frames"] = frames;
    report["passed"] = report["failures"].empty();
    const std::string text = report.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
    if (report_path.empty()) return print_result(text);
    std::ofstream stream(report_path);
    stream << text;
    if (!stream) throw Error("it cannot be written", report_path, "check the folder");
}

void Replay::presented(double frame_ms, const Stage& stage) {
    const json state = stage.state();
    Impl& play = *impl_;
    ++play.frames;
    play.frame_ms.push_back(frame_ms);
    if (state.value("bare", false)) ++play.bare_frames;
    if (!play.report.contains("first_picture_ms") && state["bins"].get<bool>())
        play.report["first_picture_ms"] = state["milliseconds"];
    if (!play.asked) return;
    // A change of the scene is answered by its first light, all else by the next frame.
    const bool retrace = state["generation"] != play.asked->state["generation"];
    if (retrace && state["stale"].get<bool>()) return;
    json& event = play.report["events"][play.asked->index];
    event["frames"] = play.frames - play.asked->frames;
    event["milliseconds"] = 1000 * (seconds_now() - play.asked->when);
    event["generation"] = state["generation"];
    event["retraced"] = retrace;
    const KeyBinding* row = binding_of(event["step"].value("key", ""));
    if (row && row->effect != Effect::retrace && (retrace || event["frames"] != 1)) {
        play.report["failures"].push_back({{"step", event["step"]}, {"what", "it was not answered by the next frame"}});
    }
    play.asked.reset();
}

void Replay::turned(double turn_ms) {
    impl_->longest_turn_ms = std::max(impl_->longest_turn_ms, turn_ms);
}

std::string step_of(const InputEvent& event, double seconds, glm::vec2 picture_size) {
    const glm::vec2 at = event.place / picture_size;
    json from = {{"kind", static_cast<int>(event.kind)}, {"at", {at.x, at.y}}};
    if (!event.key.empty()) from["key"] = event.key;
    if (event.button != Button::left) from["button"] = name_of(event.button);
    if (event.shift) from["shift"] = true;
    if (event.control) from["control"] = true;
    if (event.alt) from["alt"] = true;
    if (event.repeat) from["repeat"] = true;
    if (event.notches != 0) from["notches"] = event.notches;
    return json({{"event", from}, {"after", seconds}}).dump();
}

}  // namespace brewster
