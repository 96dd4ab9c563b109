// The one lookup of gloss: (root, fixed-point u, v, direction on the square) -> Stokes vector of the radiance that leaves.
// Valid as C++ and GLSL, under the rules of lookup.h; the includer provides uvec2 fetch_gloss_node(uint) and
// vec4 fetch_gloss_texel(uint).

struct GlossValue {
    vec3 s0, s1, s2, s3;  // red, green, blue; in the frame carried from the chart's u axis
    vec3 standard_error;  // of s0
};

BREWSTER_FUNCTION vec3 gloss_field(BREWSTER_BINS_PARAMETER uint first, vec4 x) {
    vec3 value = vec3(fetch_gloss_texel(BREWSTER_BINS first));
    value += x.x * vec3(fetch_gloss_texel(BREWSTER_BINS first + 1u));
    value += x.y * vec3(fetch_gloss_texel(BREWSTER_BINS first + 2u));
    value += x.z * vec3(fetch_gloss_texel(BREWSTER_BINS first + 3u));
    value += x.w * vec3(fetch_gloss_texel(BREWSTER_BINS first + 4u));
    return value;
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
    uint first = (node.y & ~BREWSTER_NODE_LEAF) * fields * BREWSTER_GLOSS_FIELD_TEXELS;
    GlossValue value;
    value.s1 = value.s2 = value.s3 = vec3(0.0f);
    if (unpolarized && components > 1) {
        first += uint(components) * BREWSTER_GLOSS_FIELD_TEXELS;
    } else if (components > 1) {
        value.s1 = gloss_field(BREWSTER_BINS first + BREWSTER_GLOSS_FIELD_TEXELS, x);
        value.s2 = gloss_field(BREWSTER_BINS first + 2u * BREWSTER_GLOSS_FIELD_TEXELS, x);
        if (components > 3) value.s3 = gloss_field(BREWSTER_BINS first + 3u * BREWSTER_GLOSS_FIELD_TEXELS, x);
    }
    value.s0 = max(gloss_field(BREWSTER_BINS first, x), vec3(0.0f));
    value.standard_error = vec3(fetch_gloss_texel(BREWSTER_BINS first).w, fetch_gloss_texel(BREWSTER_BINS first + 1u).w,
                                fetch_gloss_texel(BREWSTER_BINS first + 2u).w);
    return value;
}
