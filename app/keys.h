#pragma once
#include <span>
#include <string>
#include <string_view>

#include "app/input.h"

namespace brewster {

/// What a key can ask for. `argument` in the table tells apart those that come in numbers.
enum class Action {
    polarization,
    compare,
    split,
    difference,
    analyzer,
    turn_analyzer,  ///< argument: degrees
    map,            ///< argument: index in map_descriptions
    exposure,       ///< argument: thirds of EV
    fit_exposure,
    next_camera,  ///< argument: 1 or -1
    store_view,   ///< argument: 1..9
    recall_view,  ///< argument: 1..9
    home,
    frame,
    look_along,  ///< argument: 0 front, 1 right, 2 top, 3 back, 4 left
    gather,
    pause,
    restart,
    inspector,
    pick_material,
    panels,
    panel_field,
    open,
    undo,
    redo,
    copy_view,
    paste_view,
    help,
    full_screen,
    picture,  ///< argument: 0 with its legend, 1 without
    quit,
    close,
};

/// What an action costs: nothing but the window, a new picture from the bins there are, or new photons.
enum class Effect { window, redraw, retrace };

struct KeyBinding {
    Action action;
    int argument;
    std::string_view chord;  ///< "Ctrl+Alt+Shift+" as far as held, and the key
    std::string_view text;   ///< what it does; empty: told by the row before
    std::string_view group;  ///< heading in the help
    Effect effect;
};

/// The one table that input, help and tests are made from.
std::span<const KeyBinding> key_table();

/// It goes on while its key is held. What is switched is switched once, however long.
bool repeats(Action action);

/// The chord that a key event spells.
std::string chord_of(const InputEvent& event);

/// The row of that chord, or null. Shift stands for itself, so "?" and the like are not in the table.
const KeyBinding* binding_of(std::string_view chord);

/// What moves the camera while the right button is held.
inline constexpr std::string_view fly_keys = "WASDQE";

/// Motions and clicks, for the help: what is done, what it does.
struct MouseGesture {
    std::string_view gesture, text;
};
std::span<const MouseGesture> mouse_gestures();

}  // namespace brewster
