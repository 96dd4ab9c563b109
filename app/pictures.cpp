#include "app/pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <utility>

#include "app/ground_truth.h"
#include "app/report.h"
#include "app/suggestion.h"
#include "base/error.h"
#include "base/log.h"
#include "display/gathered_light.h"
#include "display/legend.h"
#include "display/osmesa_context.h"
#include "display/picture.h"
#include "display/screen.h"
#include "display/screen_pass.h"
#include "display/text.h"
#include "image/exr.h"
#include "image/png.h"

namespace brewster {
namespace {

std::vector<std::string> camera_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) names.push_back(camera.name);
    return names;
}

/// The wished cameras in their order, each once; "all" stands for every camera of the scene.
std::vector<std::string> chosen_cameras(const Scene& scene, const std::vector<std::string>& wished) {
    std::vector<std::string> known = camera_names(scene);
    if (wished.empty()) return known;
    std::vector<std::string> chosen;
    const auto choose = [&](const std::string& name) {
        if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
    };
    for (const std::string& name : wished) {
        if (std::find(known.begin(), known.end(), name) != known.end()) {
            choose(name);
        } else if (name == "all") {
            std::for_each(known.begin(), known.end(), choose);
        } else {
            std::string list;
            for (const std::string& other : known) list += (list.empty() ? "" : ", ") + other;
            throw Error("there is no camera '" + name + "'" + did_you_mean(name, known), scene.name,
                        "its cameras are " + list);
        }
    }
    return chosen;
}

/// Draws what is missing of the rendition.
void complete(Picture& picture, const Rendition& rendition, int draws) {
    const int missing = draws - picture.draws(rendition);
    if (missing > 0) picture.draw(missing, rendition);
}

/// cameras.json beside the first of the pictures.
void write_cameras(const Scene& scene, const std::vector<CameraRecord>& records) {
    const std::filesystem::path path = std::filesystem::path(records.front().path).parent_path() / "cameras.json";
    std::ofstream file(path);
    if (!(file << camera_file(scene, records)) || !file.flush())
        throw Error("cannot be written", path.string(), "check that the folder has room");
}

/// Bins lie on surfaces; only the eye's own rays bend and lose light on their way through one.
void warn_of_what_bins_see_through(const Scene& scene) {
    std::string names;
    for (const Material& material : scene.materials)
        if (material.base == Base::transparent) names += (names.empty() ? "\"" : ", \"") + material.name + "\"";
    if (!names.empty())
        log_warning("pictures from bins look straight through " + names + "; --gather on follows the light");
}

}  // namespace

void describe_picture(Image& stokes, const PictureDescription& picture) {
    const auto add = [&](const char* name, const std::string& value) {
        stokes.attributes.emplace_back(std::string("brewster.") + name, value);
    };
    add("scene", picture.scene);
    add("camera", picture.camera);
    add("photons", std::to_string(picture.photons));
    add("polarization", picture.polarization ? "on" : "off");
    add("seed", std::to_string(picture.seed));
    add("gather", picture.gather ? "on" : "off");
    add("exposure", exact_text(static_cast<double>(picture.exposure)));
}

PictureSize size_for(const Camera& camera, const std::optional<PictureSize>& wished) {
    if (wished) return *wished;
    const float width = static_cast<float>(default_picture_height) * camera.aspect_ratio;
    return {std::clamp(static_cast<int>(std::lround(width)), 1, largest_picture_side), default_picture_height};
}

std::vector<PictureName> plan_pictures(const Scene& scene, const ShotOptions& options) {
    std::vector<PictureName> pictures =
        name_pictures(options.out, chosen_cameras(scene, options.cameras), options.maps);
    prepare_folders(pictures);
    return pictures;
}

PicturesResult write_pictures(const Scene& scene, std::shared_ptr<const Snapshot> bins, const ShotOptions& options,
                              const std::vector<PictureName>& pictures, EyePictures* eye) {
    const OsmesaContext context;
    const std::uint64_t photons = bins->photons;
    Picture picture(scene);
    const ScreenPass screen_pass;
    GatheredLight gathered;
    if (!eye) warn_of_what_bins_see_through(scene);
    picture.show(std::move(bins));
    picture.upload();

    PicturesResult result;
    result.exposure =
        options.exposure ? static_cast<float>(*options.exposure) : picture.exposure_of(scene.cameras.front());
    Rendition rendition{Map::radiance, options.analyzer, options.polarization, result.exposure, options.palette};

    Text text;
    std::optional<Rays> rays;
    std::vector<CameraRecord> records;
    std::future<void> writing;  // a large picture's file, while the next one is drawn; one at a time, for their memory
    const auto finish_writing = [&] {
        if (writing.valid()) writing.get();
    };
    for (const PictureName& name : pictures) {
        const Camera& camera = scene.camera(name.camera);
        const PictureSize size = size_for(camera, options.size);
        // A file holds the linear light of one world, whatever the map.
        rendition.map = is_exr(name.path) ? Map::radiance : name.map;
        const bool from_bins = !eye || rendition.map == Map::bins;
        if (from_bins) {
            picture.look(camera, size.width, size.height);
            complete(picture, rendition, options.samples.value_or(default_samples));
        }
        if (is_exr(name.path)) {
            Image stokes =
                from_bins ? picture.stokes(options.polarization) : stokes_image(eye->of(camera), options.polarization);
            describe_picture(stokes, {scene.name, camera.name, photons, options.polarization, options.solve.engine.seed,
                                      options.gather, result.exposure});
            if (options.ground_truth) {
                if (!rays) rays.emplace(scene);
                add_ground_truth(stokes, scene, *rays, camera);
                records.push_back({camera.name, name.path, size, camera});
            }
            finish_writing();
            writing = std::async(std::launch::async,
                                 [path = name.path, file = std::move(stokes)] { write_stokes_exr(path, file); });
        } else {
            if (!from_bins) gathered.upload(eye->of(camera));
            const Screen screen = Screen::off_screen(size.width, size.height);
            screen_pass.show(screen, from_bins ? picture.light() : gathered.textures(), rendition);
            if (options.legend) draw_legend(text, screen, {rendition, scene.name, camera.name, photons});
            write_png(name.path, screen.read());
        }
    }
    finish_writing();
    if (!records.empty()) write_cameras(scene, records);
    if (eye) result.gather = eye->result();
    return result;
}

}  // namespace brewster
