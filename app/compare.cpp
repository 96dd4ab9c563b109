#include "image/compare.h"

#include "app/numbers.h"
#include "app/output.h"
#include "app/region.h"
#include "app/report.h"
#include "app/verbs.h"
#include "base/error.h"
#include "image/blocks.h"
#include "image/difference.h"
#include "image/exr.h"

namespace brewster {
namespace {

std::string summary(const PictureDifference& difference) {
    std::string text = std::to_string(difference.pixels) + " pixels\n";
    for (std::size_t component = 0; component < difference.components.size(); ++component) {
        const auto& bands = difference.components[component];
        if (!bands) continue;
        for (std::size_t i = 0; i < bands->size(); ++i) {
            const BandDifference& band = (*bands)[i];
            text += "  S" + std::to_string(component) + "." + band_letters[i] + ": mean " +
                    significant(band.mean_a, 5) + " against " + significant(band.mean_b, 5) + ", bias " +
                    significant(band.bias);
            if (band.bias_standard_error) text += " +- " + significant(*band.bias_standard_error);
            text += ", rmse " + significant(band.rmse) + " (" + significant(band.rmse_beyond_noise) +
                    " beyond noise), relative rmse " + significant(100 * band.relative_rmse) + " %";
            text += ", half of it below " + significant(100 * band.percentiles[0]) + " %, 99 % below " +
                    significant(100 * band.percentiles[2]) + " %";
            if (band.within)
                text += ", beyond 1, 2, 3 standard errors " + significant(100 * (1 - (*band.within)[0])) + ", " +
                        significant(100 * (1 - (*band.within)[1])) + ", " + significant(100 * (1 - (*band.within)[2])) +
                        " %";
            text += "\n";
        }
    }
    if (!difference.polarization) return text;
    for (std::size_t i = 0; i < difference.polarization->size(); ++i) {
        const BandPolarization& band = (*difference.polarization)[i];
        text += std::string("  DoLP.") + band_letters[i] + ": mean " + significant(100 * band.mean_dolp_a) +
                " % against " + significant(100 * band.mean_dolp_b) + " %, rmse " + significant(100 * band.dolp_rmse) +
                " %; AoLP." + band_letters[i] + ": rmse " + significant(band.aolp_rmse) + " deg, bias " +
                significant(band.aolp_bias) + " deg over " + std::to_string(band.aolp_pixels) + " pixels\n";
    }
    return text;
}

void write_difference(const CompareOptions& options, const Image& picture, const Image& reference) {
    if (options.out.ends_with(".exr")) {
        write_exr(options.out, difference_image(picture, reference));
    } else if (options.out.ends_with(".png")) {
        write_png(options.out, difference_map(picture, reference, options.epsilon, options.full_scale));
    } else {
        throw Error("the name ends neither in .png nor in .exr", "--out " + options.out, "choose one of them");
    }
}

}  // namespace

void compare_pictures(const CompareOptions& options) {
    Image picture = read_exr(options.picture), reference = read_exr(options.reference);
    if (!options.out.empty()) write_difference(options, picture, reference);
    std::vector<std::uint8_t> mask;
    if (!options.regions.empty()) {
        const Scene scene = read_scene(options.scene);
        mask = region_mask(scene, options.camera, options.regions, reference.width(), reference.height());
    }
    if (options.block > 1) {
        const bool same_size = picture.width() == reference.width() && picture.height() == reference.height();
        Blocks blocks = block_means(reference, options.block, mask);
        if (same_size) picture = block_means(picture, options.block, mask).image;
        reference = std::move(blocks.image);
        mask = std::move(blocks.mask);
    }
    const PictureDifference difference = compare(picture, reference, mask, options.epsilon);
    print_result(options.json ? compare_report(difference) : summary(difference));
}

}  // namespace brewster
