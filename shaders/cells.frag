// The cells of the bins: a colour for each piece of a chart, and of directions, that no tree divides.

#include "chart.glsl"
#include "shared/map_colours.h"

layout(location = 0) out vec4 colour;  // sRGB code

void main() {
    SeenBins seen = seen_bins(color.a * texture(albedo_texture, texture_place).a);
    uint cell = seen.direct.leaf * 0x9e3779b9u + seen.indirect.leaf * 0x85ebca6bu;
    if (seen.has_gloss) cell += seen.gloss.leaf * 0xc2b2ae35u;
    colour = vec4(cell_colour(cell), 1.0);
}
