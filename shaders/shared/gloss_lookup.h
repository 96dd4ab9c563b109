// The one lookup of gloss: (root, fixed-point u, v, direction on the square) -> Stokes vector of the radiance that leaves.
// Valid as C++ and GLSL, under the rules of lookup.h; the includer provides uvec2 fetch_gloss_node(uint) and
// vec4 fetch_gloss_texel(uint).

struct GlossValue {
    vec3 s0, s1, s2, s3;  // red, green, blue; in the frame carried from the chart's u axis
    vec3 standard_error;  // of s0
    vec3 linear_error;    // the larger one of s1 and s2
    vec3 circular_error;  // of s3
    uint leaf;
};

struct GlossField {
    vec3 value, standard_error;
};

// Of squared errors, over those that photons make: what pruning leaves under a cell, its lambda (bins/bin_settings.h) on
// the average; twice that at most.
#define BREWSTER_HIDDEN_STRUCTURE 1.7f

// Slopes err like the mean, by sqrt(3) of its error for evenly spread photons, so that a cell is known best in its middle.
BREWSTER_FUNCTION GlossField gloss_field(BREWSTER_BINS_PARAMETER uint first, vec4 x) {
    vec4 mean = fetch_gloss_texel(BREWSTER_BINS first);
    vec4 slope_0 = fetch_gloss_texel(BREWSTER_BINS first + 1u), slope_1 = fetch_gloss_texel(BREWSTER_BINS first + 2u);
    vec4 slope_2 = fetch_gloss_texel(BREWSTER_BINS first + 3u), slope_3 = fetch_gloss_texel(BREWSTER_BINS first + 4u);
    GlossField field;
    field.value = vec3(mean) + x.x * vec3(slope_0) + x.y * vec3(slope_1) + x.z * vec3(slope_2) + x.w * vec3(slope_3);
    field.standard_error = sqrt((1.0f + BREWSTER_HIDDEN_STRUCTURE) * (1.0f + 3.0f * dot(x, x))) * vec3(mean.w, slope_0.w, slope_1.w);
    return field;
}

// `components`: of the bins; `unpolarized`: the other world, which has S0 alone.
BREWSTER_FUNCTION GlossValue look_up_gloss(BREWSTER_BINS_PARAMETER uint root, int components, bool unpolarized, uint u,
                                           uint v, uint direction_u, uint direction_v) {
    uint low_0 = 0u, low_1 = 0u, low_2 = 0u, low_3 = 0u;
    uint high_0 = BREWSTER_UV_ONE, high_1 = BREWSTER_UV_ONE, high_2 = BREWSTER_UV_ONE, high_3 = BREWSTER_UV_ONE;
    uvec2 node = fetch_gloss_node(BREWSTER_BINS root);
    while ((node.y & BREWSTER_NODE_LEAF) == 0u) {
        uint child = node.y & BREWSTER_NODE_INDEX;
        uint axis = node.y >> BREWSTER_NODE_AXIS_SHIFT;
        uint at = axis == 0u ? u : axis == 1u ? v : axis == 2u ? direction_u : direction_v;
        bool low = at < node.x;
        if (!low) child += 1u;
        if (axis == 0u) {
            if (low) high_0 = node.x; else low_0 = node.x;
        } else if (axis == 1u) {
            if (low) high_1 = node.x; else low_1 = node.x;
        } else if (axis == 2u) {
            if (low) high_2 = node.x; else low_2 = node.x;
        } else {
            if (low) high_3 = node.x; else low_3 = node.x;
        }
        node = fetch_gloss_node(BREWSTER_BINS child);
    }
    vec4 x = vec4(2.0f * float(u - low_0) / float(high_0 - low_0) - 1.0f,
                  2.0f * float(v - low_1) / float(high_1 - low_1) - 1.0f,
                  2.0f * float(direction_u - low_2) / float(high_2 - low_2) - 1.0f,
                  2.0f * float(direction_v - low_3) / float(high_3 - low_3) - 1.0f);
    uint fields = components > 1 ? uint(components) + 1u : 1u;
    uint leaf = node.y & ~BREWSTER_NODE_LEAF;
    uint first = leaf * fields * BREWSTER_GLOSS_FIELD_TEXELS;
    GlossValue value;
    value.leaf = leaf;
    value.s1 = value.s2 = value.s3 = value.linear_error = value.circular_error = vec3(0.0f);
    if (unpolarized && components > 1) {
        first += uint(components) * BREWSTER_GLOSS_FIELD_TEXELS;
    } else if (components > 1) {
        GlossField s1 = gloss_field(BREWSTER_BINS first + BREWSTER_GLOSS_FIELD_TEXELS, x);
        GlossField s2 = gloss_field(BREWSTER_BINS first + 2u * BREWSTER_GLOSS_FIELD_TEXELS, x);
        value.s1 = s1.value;
        value.s2 = s2.value;
        value.linear_error = max(s1.standard_error, s2.standard_error);
        if (components > 3) {
            GlossField s3 = gloss_field(BREWSTER_BINS first + 3u * BREWSTER_GLOSS_FIELD_TEXELS, x);
            value.s3 = s3.value;
            value.circular_error = s3.standard_error;
        }
    }
    GlossField s0 = gloss_field(BREWSTER_BINS first, x);
    value.s0 = max(s0.value, vec3(0.0f));
    value.standard_error = s0.standard_error;
    return value;
}
