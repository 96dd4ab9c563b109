#pragma once
#include <functional>
#include <optional>
#include <string>

#include "app/inspection.h"
#include "app/keys.h"
#include "app/session.h"
#include "app/state.h"

namespace brewster {

/// What panels see and may ask for. They hold no logic of the engine and call no OpenGL.
struct Desk {
    // To look at.
    const Scene& scene;
    const Session& session;
    Progress progress;
    double frame_ms = 0;              ///< of the last drawn frame
    double samples = 0;               ///< the picture at rest is made of
    double gathered = 0;              ///< share of the picture that is made of the eye's own rays
    std::uint64_t photons_shown = 0;  ///< whose bins the picture ends in
    std::optional<double> taking;     ///< share of the samples of a picture for a file
    std::optional<SeenLight> light;
    std::optional<SeenSurface> surface;
    bool region = false;  ///< the light is a mean over a rectangle
    float scale = 1;      ///< pixels per pixel of text at scale 1

    // To change.
    Sight& view;
    Preferences& preferences;
    Shown& shown;

    // To ask for.
    std::function<void(Action, int argument)> act;
    /// The scene as it is with that setting; the first of a row that undo takes back as one begins a new step.
    std::function<void(std::shared_ptr<const Scene>, const Setting&, bool new_step)> change_scene;
    std::function<void(const std::string& path)> open_file;
    std::function<void(const std::string& path)> save;  ///< .png, .exr
    std::function<void()> save_solution;
    std::function<void(std::optional<double>)> set_target_error;
    std::function<void(const std::string&)> copy;  ///< to the clipboard
};

/// Each draws its own part of the column or a window of its own.
void polarization_panel(Desk& desk);
void materials_panel(Desk& desk);
void inspector_panel(Desk& desk);
void progress_panel(Desk& desk);
void view_panel(Desk& desk);
void files_window(Desk& desk);
void help_window(Desk& desk);
void first_run_card(Desk& desk);
void complaint_window(Desk& desk);

/// The wheel of the analyzer, drawn on the picture with the frame that angles refer to; it can be turned by the mouse.
/// `middle` and `radius` in pixels.
void analyzer_wheel(Desk& desk, glm::vec2 middle, float radius);
/// The line between both worlds; it can be moved.
void split_slider(Desk& desk, glm::vec2 picture_size);

/// Columns of pixels that the panels take on the right of a window; none where it is too narrow for both.
int column_width(bool panels, float scale, int window_width);
/// All of it, docked to the right.
void panel_column(Desk& desk, glm::ivec2 window_size);

}  // namespace brewster
