#include "app/keys.h"

#include <array>

namespace brewster {
namespace {

constexpr std::string_view polarization = "Polarization", maps = "Maps", look = "Looking around", trace = "Tracing",
                           window = "Window and files";

constexpr std::array table{
    KeyBinding{Action::polarization, 0, "P", "polarization on and off", polarization, Effect::redraw},
    KeyBinding{Action::compare, 0, "C", "hold: the other world", polarization, Effect::redraw},
    KeyBinding{Action::split, 0, "V", "both worlds, a slider between them", polarization, Effect::redraw},
    KeyBinding{Action::difference, 0, "D", "difference on minus off", polarization, Effect::redraw},
    KeyBinding{Action::analyzer, 0, "A", "analyzer in front of the camera", polarization, Effect::redraw},
    KeyBinding{Action::turn_analyzer, 1, ",", "turn it 1 degree counter-clockwise", polarization, Effect::redraw},
    KeyBinding{Action::turn_analyzer, -1, ".", "turn it 1 degree clockwise", polarization, Effect::redraw},
    KeyBinding{Action::turn_analyzer, 10, "Shift+,", "turn it 10 degrees counter-clockwise", polarization,
               Effect::redraw},
    KeyBinding{Action::turn_analyzer, -10, "Shift+.", "turn it 10 degrees clockwise", polarization, Effect::redraw},
    KeyBinding{Action::map, 0, "1", "radiance", maps, Effect::redraw},
    KeyBinding{Action::map, 1, "2", "S1", maps, Effect::redraw},
    KeyBinding{Action::map, 2, "3", "S2", maps, Effect::redraw},
    KeyBinding{Action::map, 3, "4", "S3", maps, Effect::redraw},
    KeyBinding{Action::map, 4, "5", "degree of polarization", maps, Effect::redraw},
    KeyBinding{Action::map, 5, "6", "degree of linear polarization", maps, Effect::redraw},
    KeyBinding{Action::map, 6, "7", "angle of linear polarization", maps, Effect::redraw},
    KeyBinding{Action::map, 7, "8", "degree of circular polarization", maps, Effect::redraw},
    KeyBinding{Action::map, 8, "9", "type of polarization", maps, Effect::redraw},
    KeyBinding{Action::map, 10, "0", "relative standard error", maps, Effect::redraw},
    KeyBinding{Action::map, 11, "B", "bins that hold the light", maps, Effect::redraw},
    KeyBinding{Action::exposure, 1, "E", "brighter by a third of a stop", look, Effect::redraw},
    KeyBinding{Action::exposure, -1, "Shift+E", "darker", look, Effect::redraw},
    KeyBinding{Action::fit_exposure, 0, "=", "exposure that fits the scene", look, Effect::redraw},
    KeyBinding{Action::next_camera, 1, "N", "next camera of the file", look, Effect::redraw},
    KeyBinding{Action::next_camera, -1, "Shift+N", "previous camera", look, Effect::redraw},
    KeyBinding{Action::home, 0, "Home", "back to the camera", look, Effect::redraw},
    KeyBinding{Action::frame, 0, "F", "come near what was picked, or see all", look, Effect::redraw},
    KeyBinding{Action::look_along, 0, "Keypad 1", "from the front", look, Effect::redraw},
    KeyBinding{Action::look_along, 3, "Ctrl+Keypad 1", "from behind", look, Effect::redraw},
    KeyBinding{Action::look_along, 1, "Keypad 3", "from the right", look, Effect::redraw},
    KeyBinding{Action::look_along, 4, "Ctrl+Keypad 3", "from the left", look, Effect::redraw},
    KeyBinding{Action::look_along, 2, "Keypad 7", "from above", look, Effect::redraw},
    KeyBinding{Action::store_view, 1, "Ctrl+1", "keep this view, up to Ctrl+9", look, Effect::window},
    KeyBinding{Action::store_view, 2, "Ctrl+2", "", look, Effect::window},
    KeyBinding{Action::store_view, 3, "Ctrl+3", "", look, Effect::window},
    KeyBinding{Action::store_view, 4, "Ctrl+4", "", look, Effect::window},
    KeyBinding{Action::store_view, 5, "Ctrl+5", "", look, Effect::window},
    KeyBinding{Action::store_view, 6, "Ctrl+6", "", look, Effect::window},
    KeyBinding{Action::store_view, 7, "Ctrl+7", "", look, Effect::window},
    KeyBinding{Action::store_view, 8, "Ctrl+8", "", look, Effect::window},
    KeyBinding{Action::store_view, 9, "Ctrl+9", "", look, Effect::window},
    KeyBinding{Action::recall_view, 1, "Alt+1", "go to the view that was kept, up to Alt+9", look, Effect::redraw},
    KeyBinding{Action::recall_view, 2, "Alt+2", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 3, "Alt+3", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 4, "Alt+4", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 5, "Alt+5", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 6, "Alt+6", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 7, "Alt+7", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 8, "Alt+8", "", look, Effect::redraw},
    KeyBinding{Action::recall_view, 9, "Alt+9", "", look, Effect::redraw},
    KeyBinding{Action::gather, 0, "G", "rays of the eye's own at rest, on and off", trace, Effect::redraw},
    KeyBinding{Action::pause, 0, "Space", "pause and go on", trace, Effect::window},
    KeyBinding{Action::restart, 0, "Ctrl+R", "trace anew", trace, Effect::retrace},
    KeyBinding{Action::inspector, 0, "I", "inspector under the pointer", trace, Effect::window},
    KeyBinding{Action::pick_material, 0, "M", "material under the pointer", trace, Effect::window},
    KeyBinding{Action::undo, 0, "Ctrl+Z", "undo a change of the scene", trace, Effect::retrace},
    KeyBinding{Action::redo, 0, "Ctrl+Y", "do it again", trace, Effect::retrace},
    KeyBinding{Action::panels, 0, "Tab", "panels, on and off", window, Effect::window},
    KeyBinding{Action::panel_field, 0, "Ctrl+Tab", "type a number; Tab goes to the next", window, Effect::window},
    KeyBinding{Action::open, 0, "O", "open a file", window, Effect::window},
    KeyBinding{Action::copy_view, 0, "Ctrl+C", "copy the view as text", window, Effect::window},
    KeyBinding{Action::paste_view, 0, "Ctrl+V", "go to the view in the clipboard", window, Effect::redraw},
    KeyBinding{Action::picture, 0, "F12", "save the picture, without panels", window, Effect::window},
    KeyBinding{Action::picture, 1, "Ctrl+F12", "save it without its legend, too", window, Effect::window},
    KeyBinding{Action::full_screen, 0, "F11", "full screen", window, Effect::window},
    KeyBinding{Action::help, 0, "H", "this help", window, Effect::window},
    KeyBinding{Action::help, 0, "F1", "", window, Effect::window},
    KeyBinding{Action::close, 0, "Escape", "close what is on top", window, Effect::window},
    KeyBinding{Action::quit, 0, "Ctrl+Q", "quit", window, Effect::window},
};

constexpr std::array gestures{
    MouseGesture{"left drag", "turn around what is in the middle"},
    MouseGesture{"double click", "turn around what is there from now on"},
    MouseGesture{"middle or Shift+left drag", "shift"},
    MouseGesture{"wheel", "come nearer to what is under the pointer"},
    MouseGesture{"right held, W A S D Q E", "fly; Shift is faster"},
    MouseGesture{"Alt+wheel", "turn the analyzer"},
    MouseGesture{"Ctrl+left drag", "mean over a rectangle, in the inspector"},
};

}  // namespace

std::span<const KeyBinding> key_table() {
    return table;
}

std::span<const MouseGesture> mouse_gestures() {
    return gestures;
}

bool repeats(Action action) {
    return action == Action::turn_analyzer || action == Action::exposure;
}

std::string chord_of(const InputEvent& event) {
    return std::string(event.control ? "Ctrl+" : "") + (event.alt ? "Alt+" : "") + (event.shift ? "Shift+" : "") +
           event.key;
}

const KeyBinding* binding_of(std::string_view chord) {
    for (const KeyBinding& row : table)
        if (row.chord == chord) return &row;
    return nullptr;
}

}  // namespace brewster
