#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "display/maps.h"
#include "display/text.h"

namespace brewster {

/// What a picture's legend says.
struct Legend {
    Map map = Map::radiance;
    std::string scene, camera;
    std::uint64_t photons = 0;
    float exposure = 0;        ///< EV
    bool polarization = true;  ///< off: said in the legend
};

/// A count in few signs: "950", "1.2e4", "1e7".
std::string brief_count(std::uint64_t count);

/// The powers of ten from `low` to `high`, evenly thinned to at most `most`.
std::vector<double> scale_marks(double low, double high, int most);

/// Draws the legend into the lower left corner: the map's scale in the colours that the tone curve gives them at this
/// exposure, the names, the photons so far. A screen too small to hold it stays without.
void draw_legend(Text& text, const Screen& screen, const Legend& legend);

}  // namespace brewster
