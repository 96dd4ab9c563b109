#pragma once
#include <cstdint>
#include <string>

#include "display/rendition.h"
#include "display/text.h"

namespace brewster {

/// What a picture's legend says.
struct Legend {
    Rendition rendition;
    std::string scene, camera;
    std::uint64_t photons = 0;
    float text_scale = 1;
    float content_scale = 1;  ///< of the desktop, which pixels are small on
};

/// A count in few signs: "950", "1.2e4", "1e7".
std::string brief_count(std::uint64_t count);

/// "analyzer 30 deg", "right circular analyzer"; empty without one.
std::string analyzer_words(const Analyzer& analyzer);

/// Height of its letters in pixels, which follows the screen's; as large as letters are made at most.
int legend_text_size(int screen_height, float text_scale = 1, float content_scale = 1);

/// Draws the legend into the lower left corner: the map's scale in the very colours of the map, the names, the photons so
/// far, what stands in front of the camera. A screen too small to hold it stays without.
void draw_legend(Text& text, const Screen& screen, const Legend& legend);

}  // namespace brewster
