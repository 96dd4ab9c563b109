#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/options.h"
#include "app/view.h"
#include "scene/scene.h"

namespace brewster {

/// Throws Error that names the word which cannot be understood.
View parse_view(std::string_view text);

/// One view a line; empty lines and those that begin with # are left out. Throws Error for a file that cannot be read.
std::vector<View> read_views(const std::string& path);

/// What parse_view reads back as the same view, numbers to the last digit.
std::string view_text(const View& view);

/// The pose of a camera of this scene, in the file's coordinates.
View::Pose pose_of(const Scene& scene, const Camera& camera);

/// The camera that the view names or describes, of the aspect ratio of its size. Throws Error for an unknown name and for
/// a pose that looks nowhere.
Camera camera_of(const Scene& scene, const View& view);

/// Sets what the view says; where it has a camera, that is one more of `options.views`.
void apply_view(const View& view, ShotOptions& options);

/// Gives the scene the cameras of `options.views` and chooses them. A pose without a name is called "view"; one that has
/// the name of a camera there is, "front (moved)": the scene's own stay what they are, its exposure hangs on them.
void add_views(Scene& scene, ShotOptions& options);

}  // namespace brewster
