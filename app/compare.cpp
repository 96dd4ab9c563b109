#include "image/compare.h"

#include "app/numbers.h"
#include "app/output.h"
#include "app/report.h"
#include "app/verbs.h"
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
            text += ", rmse " + significant(band.rmse) + ", relative rmse " + significant(100 * band.relative_rmse) +
                    " %\n";
        }
    }
    return text;
}

}  // namespace

void compare_pictures(const CompareOptions& options) {
    const Image picture = read_exr(options.picture), reference = read_exr(options.reference);
    const PictureDifference difference = compare(picture, reference);
    print_result(options.json ? compare_report(difference) : summary(difference));
}

}  // namespace brewster
