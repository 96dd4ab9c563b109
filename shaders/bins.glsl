// The bins as shaders see them: long arrays of texels, in buffer textures or, with BREWSTER_TEXEL_ROW, in rows of that
// many texels of a 2-D texture. Written by display/texel_array and display/upload.

#include "shared/bin_layout.h"

#ifdef BREWSTER_TEXEL_ROW
#define UINT_TEXELS usampler2D
#define FLOAT_TEXELS sampler2D
#define TEXEL(array, index) texelFetch(array, ivec2((index) % BREWSTER_TEXEL_ROW, (index) / BREWSTER_TEXEL_ROW), 0)
#else
#define UINT_TEXELS usamplerBuffer
#define FLOAT_TEXELS samplerBuffer
#define TEXEL(array, index) texelFetch(array, int(index))
#endif

uniform UINT_TEXELS bin_nodes;
uniform FLOAT_TEXELS bin_leaves;
uniform UINT_TEXELS chart_roots;  // two texels a chart: direct, indirect; gloss, or 0xffffffff
uniform UINT_TEXELS gloss_nodes;
uniform FLOAT_TEXELS gloss_leaves;

uvec2 fetch_node(uint index) { return TEXEL(bin_nodes, index).xy; }
vec4 fetch_leaf_texel(uint index) { return TEXEL(bin_leaves, index); }
uvec2 fetch_gloss_node(uint index) { return TEXEL(gloss_nodes, index).xy; }
vec4 fetch_gloss_texel(uint index) { return TEXEL(gloss_leaves, index); }

#define BREWSTER_BINS_PARAMETER
#define BREWSTER_BINS
#include "shared/lookup.h"
#include "shared/gloss_lookup.h"
#include "shared/direction_map.h"
