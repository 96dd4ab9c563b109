#pragma once
#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "app/canvas.h"
#include "app/gatherer.h"
#include "app/motion_resolution.h"
#include "app/moving_glimpse.h"
#include "app/navigation.h"
#include "app/options.h"
#include "app/overlay.h"
#include "app/panels/desk.h"
#include "app/replay.h"
#include "app/scene_file.h"
#include "app/session.h"
#include "app/state.h"
#include "app/taken_picture.h"
#include "app/window.h"

namespace brewster {

/// The window's loop: takes what a person does, lets the session and the canvas follow, draws only when something has
/// changed. viewer.cpp holds the loop and the drawing, actions.cpp what keys and the mouse do,
/// saving.cpp what goes into files.
class Viewer {
  public:
    /// `started`: the program, on the clock of seconds_now.
    Viewer(Window& window, std::shared_ptr<const Scene> scene, const OpenOptions& options, double started);
    ~Viewer();

    /// Until the window is closed or Ctrl+Q is pressed. False if a script found something that is not as it expected.
    bool run();

  private:
    // actions.cpp
    void handle(const InputEvent& event);
    void press(const InputEvent& event);
    void drag_region(const InputEvent& event);
    void act(Action action, int argument);
    void go_to(const Camera& camera);
    void turn_analyzer(double degrees);
    void pick_material();
    void frame_selection();
    void close_topmost();
    void fly(double seconds);
    std::string words() const;  ///< the view as text
    void go_to_words(const std::string& text);
    void notice(const std::string& text);

    // viewer.cpp
    void take_file();
    void remember_file(const std::string& path);
    void take_bins();
    void make_widgets();
    void look_around_pointer();
    void gather_at_rest();
    void draw();
    Caption caption();
    void present();
    void set_scene(std::shared_ptr<const Scene> scene, std::uint64_t generation, bool same_surfaces);
    void follow_session();
    void wait();
    double patience() const;
    double seconds_between() const;
    bool moving() const;
    bool fresh() const;
    int shrinking() const;
    bool drawing_wanted() const;
    glm::ivec2 picture_size() const;
    Desk desk();
    std::optional<glm::vec3> seen(const Camera& camera, glm::vec2 place) const;

    // saving.cpp
    std::string name_of(const Camera& camera) const;  ///< and whether it was moved away from where the file has it
    /// A path that does not exist yet, for what is seen or traced; `kind`: its ending.
    std::string new_path(const std::string& kind) const;
    void take_picture(const std::string& path, bool legend);
    void advance_taken_picture();
    std::string taking_words() const;  ///< how far it is
    void save_solution(const std::string& path);
    void take_saved_solution();

    // scripted.cpp
    Stage make_stage();
    void record(const InputEvent& event);

    Window& window_;
    const std::vector<Setting> settings_;  ///< of --set, for every file
    Overlay overlay_;
    SceneFile file_;
    Session session_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Scene> surfaces_;  ///< the scene that the rays know
    std::unique_ptr<Rays> rays_;
    Canvas canvas_;
    Gatherer gatherer_;
    Navigation navigation_;
    MotionResolution resolution_;
    MovingGlimpse glimpse_;

    Sight view_;
    std::array<std::optional<Sight>, 9> kept_views_;
    Preferences preferences_;
    Preferences written_preferences_;
    Shown shown_;
    std::string home_camera_;

    std::optional<glm::vec2> inspected_;  ///< place in the picture, in pixels
    std::optional<SeenLight> light_;
    std::optional<SeenSurface> surface_;
    std::optional<std::array<glm::vec2, 2>> region_;  ///< corners in pixels
    bool dragging_region_ = false, comparing_ = false, quit_ = false;
    bool exposure_settled_ = false;  ///< it does not follow the bins any more
    bool exposure_by_hand_ = false;
    std::string held_fly_keys_;
    std::unique_ptr<TakenPicture> taken_;  ///< on its way into a file
    std::string said_of_taking_;           ///< in the frame that is shown
    std::string solution_path_;            ///< the same of a solution

    double started_;
    std::unique_ptr<Replay> replay_;
    Stage stage_;
    std::ofstream record_;
    double last_recorded_ = 0;
    std::optional<std::string> wanted_capture_;  ///< a file to be written with the next frame

    std::uint64_t shown_generation_ = 0;  ///< whose materials are shown
    std::uint64_t bins_generation_ = 0;   ///< whose light
    std::uint64_t sent_generation_ = 0;   ///< whose light is on its way to the graphics side, or there
    bool keeps_resolution_ = false;       ///< of moving pictures, for measuring
    bool must_present_ = true, improved_ = false, hidden_ = false;
    int draws_to_present_ = 1;
    bool presents_at_once_ = false;  ///< the bins that were taken last
    bool band_is_overdue_ = false;   ///< of a slow draw: the turn before presented in its place
    int widget_frames_ = 2;          ///< frames that widgets still want, to answer what was done
    int shrinking_ = 1;              ///< of each side of what is drawn
    bool making_room_ = false;       ///< for the eye's rays
    double bins_since_ = -1e9;       ///< when the first bins of the generation came
    double last_motion_ = -1e9, last_present_ = -1e9, last_look_at_file_ = 0, last_step_ = 0, last_press_ = -1e9;
    glm::vec2 last_press_place_{0.0f};
    double frame_seconds_ = 0, frame_begin_ = 0, pause_ = 0;
};

}  // namespace brewster
