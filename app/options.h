#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/numbers.h"
#include "app/settings.h"
#include "app/view.h"
#include "display/rendition.h"
#include "engine/engine.h"
#include "image/compare.h"

namespace brewster {

inline constexpr std::uint64_t default_photons = 10'000'000;

struct SolveOptions {
    std::string scene;              ///< path of a .gltf or .glb file; empty: the scene in the binary
    std::vector<Setting> settings;  ///< changes of its materials and lamps
    StopRule stop;
    EngineSettings engine;
    std::string resume;  ///< a saved solution to go on from: its settings hold; empty: none
    std::string save;    ///< where the solution is kept; empty: nowhere
    bool json = false;
};

struct ShotOptions {
    SolveOptions solve;                ///< with `resume`: pictures of what was saved, no more photons
    std::vector<std::string> cameras;  ///< empty and no views: all
    std::vector<View> views;           ///< cameras in words
    std::optional<PictureSize> size;   ///< none: default_picture_height and the camera's shape
    std::vector<Map> maps = {Map::radiance};
    Palette palette = Palette::blue_orange;
    Analyzer analyzer;
    std::optional<double> exposure;  ///< EV; none: found from the first camera of the scene
    /// Draws for each pixel, on the mean, that a picture is made of; none: default_samples, or as many as seconds and
    /// target error of a gathered picture let come.
    std::optional<int> samples;
    bool gather = true;              ///< rays of the eye that end in the bins; else the bins alone
    bool legend = true;              ///< in PNG pictures
    bool ground_truth = false;       ///< EXR pictures also hold what a camera cannot see, and the cameras go to a file
    bool polarization = true;        ///< off: the world where no surface can tell polarizations apart
    std::string out = "pictures/{camera}.png";
};

inline constexpr int default_picture_height = 480;
inline constexpr int default_samples = 64;

/// A picture file of linear light, shown as `shot` would show it.
struct DevelopOptions {
    std::string picture;  ///< path of an EXR file
    std::vector<Map> maps = {Map::radiance};
    Palette palette = Palette::blue_orange;
    Analyzer analyzer;
    std::optional<double> exposure;  ///< EV; none: the file's, else found from the picture
    bool legend = true;
    std::string out = "{map}.png";
    std::string scene, camera;         ///< what it shows; needed for a region
    std::vector<std::string> regions;  ///< meshes over which means are taken; empty: the whole picture
    bool json = false;
};

struct InfoOptions {
    std::string scene;
    std::vector<Setting> settings;
    bool json = false;
};

struct ReferenceOptions {
    std::string scene;
    std::vector<Setting> settings;
    std::string camera;                ///< empty: the first
    std::optional<PictureSize> size;   ///< none: default_picture_height and the camera's shape
    std::optional<std::uint64_t> spp;  ///< samples for each pixel
    std::optional<double> seconds;     ///< whichever is reached first; neither: default_reference_samples
    bool polarized = true;
    std::uint64_t seed = 1;
    unsigned threads = 0;  ///< 0: as many as the machine has
    std::string out = "reference.exr";
    bool json = false;
};

inline constexpr std::uint64_t default_reference_samples = 64;

struct CompareOptions {
    std::string picture, reference;    ///< paths of EXR files
    std::string scene, camera;         ///< what both pictures show; needed for a region
    std::vector<std::string> regions;  ///< meshes; empty: the whole picture
    int block = 1;                     ///< pixels a side of the blocks whose means are compared
    double epsilon = default_epsilon;  ///< see compare in image/compare.h
    std::string out;                   ///< a difference picture, .png or .exr; empty: none
    double full_scale = 0.1;           ///< relative difference of full colour in a .png
    bool json = false;
};

/// The program without a verb.
struct OpenOptions {
    std::string scene;  ///< empty: the scene in the binary
    std::vector<Setting> settings;
    StopRule stop;  ///< empty: a window goes on for ever, pictures take default_photons
    EngineSettings engine;
    bool headless = false;  ///< draw pictures even where a window could be opened
    std::string replay;     ///< a script to play into the window; empty: none
    std::string report;     ///< where its outcome goes; empty: standard output
    std::string record;     ///< where to write a script of what is done; empty: nowhere
};

using Command =
    std::variant<OpenOptions, SolveOptions, ShotOptions, DevelopOptions, InfoOptions, ReferenceOptions, CompareOptions>;

}  // namespace brewster
