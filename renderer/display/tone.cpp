#include "display/tone.h"

#include <algorithm>
#include <vector>

namespace brewster {

float auto_exposure(const Image& radiance) {
    const std::vector<float>& red = radiance.channel(stokes_channel(0, 0));
    const std::vector<float>& green = radiance.channel(stokes_channel(0, 1));
    const std::vector<float>& blue = radiance.channel(stokes_channel(0, 2));
    std::vector<double> lit;
    double sum = 0;
    for (std::size_t i = 0; i < red.size(); ++i) {
        const double greatest = std::max({red[i], green[i], blue[i]});
        if (!(greatest > 0)) continue;
        lit.push_back(greatest);
        sum += greatest;
    }
    if (lit.empty()) return 0.0f;
    const double count = static_cast<double>(lit.size());
    const double least = 1e-4 * sum / count;
    double logarithms = 0;
    for (const double value : lit) logarithms += std::log2(std::max(value, least));
    constexpr double middle_grey = 0.18;
    const double exposure = std::log2(middle_grey) - logarithms / count;
    return static_cast<float>(std::round(10.0 * exposure) / 10.0);
}

}  // namespace brewster
