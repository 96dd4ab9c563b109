#include "app/analyzer_text.h"
#include "app/numbers.h"
#include "app/output.h"
#include "app/picture_names.h"
#include "app/region.h"
#include "app/report.h"
#include "app/verbs.h"
#include "base/error.h"
#include "base/log.h"
#include "display/gathered_light.h"
#include "display/legend.h"
#include "display/osmesa_context.h"
#include "display/screen_pass.h"
#include "display/tone.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/stokes_picture.h"

namespace brewster {
namespace {

/// The file's attribute, or `otherwise`.
std::string attribute(const Image& image, const std::string& name, const std::string& otherwise) {
    for (const auto& [key, text] : image.attributes)
        if (key == "brewster." + name) return text;
    return otherwise;
}

std::vector<Map> shown_maps(const DevelopOptions& options) {
    std::vector<Map> maps;
    const bool all = options.maps.size() == map_descriptions.size();
    for (const Map map : options.maps) {
        const bool possible = map != Map::difference && map != Map::bins;
        if (!possible && !all)
            throw Error("the map '" + std::string(description(map).name) + "' needs more than the light of one world",
                        options.picture, "draw it with brewster shot");
        if (possible) maps.push_back(map);
    }
    return maps;
}

std::string summary(const PictureStatistics& statistics) {
    std::string text = std::to_string(statistics.pixels) + " pixels\n";
    for (std::size_t i = 0; i < statistics.bands.size(); ++i) {
        const BandStatistics& band = statistics.bands[i];
        text += std::string("  ") + band_letters[i] + ":";
        for (std::size_t component = 0; component < 4; ++component)
            text += " S" + std::to_string(component) + " " + significant(band.mean[component], 5) + " +- " +
                    significant(band.standard_error[component], 2);
        text += "; DoP " + significant(100 * band.dop) + " %, DoLP " + significant(100 * band.dolp) + " %, DoCP " +
                significant(100 * band.docp) + " %";
        if (band.aolp) text += ", AoLP " + significant(*band.aolp) + " deg";
        text += "\n";
    }
    return text;
}

void write_maps(const Image& image, const DevelopOptions& options, const std::vector<PictureName>& pictures) {
    const OsmesaContext context;
    GatheredLight light;
    light.upload(stokes_picture(image));
    const ScreenPass screen_pass;
    Text text;
    Rendition rendition;
    rendition.analyzer = options.analyzer;
    rendition.palette = options.palette;
    rendition.polarization = attribute(image, "polarization", "on") != "off";
    const std::optional<double> of_file = parse_number(attribute(image, "exposure", ""));
    rendition.exposure = options.exposure ? static_cast<float>(*options.exposure)
                         : of_file        ? static_cast<float>(*of_file)
                                          : auto_exposure(stokes_image(stokes_picture(image), true));
    const std::optional<std::uint64_t> photons = parse_whole_number(attribute(image, "photons", "0"));
    for (const PictureName& name : pictures) {
        rendition.map = name.map;
        const Screen screen = Screen::off_screen(image.width(), image.height());
        screen_pass.show(screen, light.textures(), rendition);
        if (options.legend)
            draw_legend(text, screen,
                        {rendition, attribute(image, "scene", options.picture), name.camera, photons.value_or(0)});
        write_png(name.path, screen.read());
    }
}

}  // namespace

void develop(const DevelopOptions& options) {
    if (options.json) log_only_warnings();
    const Image image = read_exr(options.picture);
    const std::vector<PictureName> pictures =
        name_pictures(options.out, {attribute(image, "camera", "camera")}, shown_maps(options));
    for (const PictureName& picture : pictures)
        if (is_exr(picture.path))
            throw Error("it would be no picture for the eye", "--out " + options.out, "end the name in .png");
    prepare_folders(pictures);
    std::vector<std::uint8_t> mask;
    if (!options.regions.empty())
        mask = region_mask(read_scene(options.scene), options.camera, options.regions, image.width(), image.height());
    const PictureStatistics means = statistics(image, mask);
    write_maps(image, options, pictures);
    if (options.json) return print_result(develop_report(pictures, means));
    std::string list;
    for (const PictureName& picture : pictures) list += picture.path + "\n";
    print_result(list + summary(means));
}

}  // namespace brewster
