#pragma once
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "display/rendition.h"

namespace brewster {

struct ScaleMark {
    double place = 0;  ///< along the strip, [0, 1]
    std::string label;
};

/// The strip in a legend: the colours of a map over its values.
struct LegendScale {
    /// sRGB code at a place along the strip and, for maps of two values, at a height; both in [0, 1].
    std::function<glm::vec3(float place, float height)> colour;
    bool two_values = false;  ///< the height matters
    std::vector<ScaleMark> marks;
};

/// Without a colour function where the map's colours stand for no value.
LegendScale legend_scale(const Rendition& rendition);

/// The powers of ten from `low` to `high`, evenly thinned to at most `most`.
std::vector<double> scale_marks(double low, double high, int most);

/// Which labels, each from x to y, stand apart by `gap`; where two do not, the later one is left out.
std::vector<bool> readable_labels(const std::vector<glm::vec2>& places, float gap);

}  // namespace brewster
