#pragma once
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/input.h"
#include "app/state.h"

namespace brewster {

/// What a script can do to the window, and see of it.
struct Stage {
    std::function<void(const InputEvent&)> input;           ///< as if a person had done it
    std::function<void(const std::string&)> type;           ///< into the widget that has the keyboard
    std::function<void(const std::string&)> set;            ///< MATERIAL.PROPERTY=VALUE, as a slider would
    std::function<void(const std::string&)> open;           ///< a file
    std::function<void(const std::string&)> save;           ///< a picture of what is seen, .png or .exr
    std::function<void(const std::string&)> save_solution;  ///< of what is traced, .bins
    std::function<void(int width, int height)> resize;
    std::function<void(bool)> minimise;
    std::function<void(bool)> make_flat;              ///< bins that say the same everywhere, for measuring
    std::function<void(const std::string&)> capture;  ///< the window as it is, .png
    std::function<void()> quit;
    std::function<nlohmann::json()> state;  ///< what there is now, for expectations
};

/// Plays a script into the window and writes down what came of it, for tests and measurements. A script is JSON:
/// {"steps": [STEP ...], "seconds": 60}, played again and again for so long (once without), each step an object with one
/// verb:
///   {"key": "Shift+,"}                                   pressed and released; a failure if the next frame does not
///                                                       answer, or if photons fly for what needs none
///   {"hold": "C"}  {"let_go": "C"}
///   {"move": [x, y]}  {"click": [x, y], "button": "left"}  {"wheel": notches, "at": [x, y]}
///   {"drag": [x, y, x, y], "button": "left", "shift": true, "frames": 20}   with "measure": see below
///   {"type": "0.3"}  {"set": "floor.roughness=0.3"}  {"open": "file.gltf"}  {"save": "a.png"}  {"save_solution": "a.bins"}
///   {"resize": [width, height]}  {"minimise": true}  {"flat": true}  {"capture": "a.png"}
///   {"event": {...}}                                     as --record writes it
///   {"wait": seconds}  {"until": {"stale": false}, "seconds": 10}   compared as in expect
///   {"expect": {"map": "dolp", "photons": {">": 1e6}, "complaint": {"not": ""}}}   a failure if it is not so
///   {"remember": ["eye", "exposure"]}                    for {"expect": {"eye": {"remembered": true}}}
///   {"measure": "name", "seconds": 3}                    frames, photons, processor time meanwhile; "until" can, too
/// Places are shares of the picture, from its upper left.
class Replay {
  public:
    /// Throws Error when the script cannot be read. `report`: where the outcome goes, JSON; empty: standard output.
    Replay(const std::string& script, std::string report);
    ~Replay();

    /// Does what is due. False when the script is at its end, and its report written.
    bool advance(Stage& stage);
    /// To be called with every frame that reaches the screen; `frame_ms`: milliseconds it took to draw.
    void presented(double frame_ms, const Stage& stage);
    /// To be called with the milliseconds of every turn of the window's loop, its sleep not counted: so long can input
    /// have had to wait.
    void turned(double turn_ms);
    /// Seconds that the window may sleep without missing what is due.
    double patience() const;
    bool failed() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// One event as a step of a script, `seconds` after the one before.
std::string step_of(const InputEvent& event, double seconds, glm::vec2 picture_size);

}  // namespace brewster
