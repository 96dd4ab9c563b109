// The one lookup: (chart tree, fixed-point u, v) -> entered flux per area and its standard error. Valid as C++ and
// GLSL. The includer provides uvec2 fetch_node(uint) and vec4 fetch_leaf_texel(uint), and three macros that are empty
// in GLSL: BREWSTER_FUNCTION (inline), BREWSTER_BINS_PARAMETER and BREWSTER_BINS (how C++ reaches the bins).

struct BinValue {
    vec3 value;           // entered flux per area, red, green, blue
    vec3 standard_error;  // of the leaf
    uint leaf;
};

// [0, 1] -> fixed point; what lies outside is clamped to the border.
BREWSTER_FUNCTION uint fixed_point_of(float unit) {
    float scaled = clamp(unit, 0.0f, 1.0f) * 16777216.0f;
    return uint(min(scaled, 16777215.0f));
}

// The value of the leaf under (u, v) in the tree that begins at node `root`; `world`: how many leaves behind the node's
// the wanted world stands.
BREWSTER_FUNCTION BinValue look_up(BREWSTER_BINS_PARAMETER uint root, uint world, uint u, uint v) {
    uint low_u = 0u, low_v = 0u;
    uint high_u = BREWSTER_UV_ONE, high_v = BREWSTER_UV_ONE;
    uvec2 node = fetch_node(BREWSTER_BINS root);
    while ((node.y & BREWSTER_NODE_LEAF) == 0u) {
        uint child = node.y & BREWSTER_NODE_INDEX;
        if ((node.y >> BREWSTER_NODE_AXIS_SHIFT) == 0u) {
            if (u < node.x) {
                high_u = node.x;
            } else {
                low_u = node.x;
                child += 1u;
            }
        } else {
            if (v < node.x) {
                high_v = node.x;
            } else {
                low_v = node.x;
                child += 1u;
            }
        }
        node = fetch_node(BREWSTER_BINS child);
    }
    uint first = ((node.y & ~BREWSTER_NODE_LEAF) + world) * BREWSTER_LEAF_TEXELS;
    vec4 low_low = fetch_leaf_texel(BREWSTER_BINS first);
    vec4 high_low = fetch_leaf_texel(BREWSTER_BINS first + 1u);
    vec4 low_high = fetch_leaf_texel(BREWSTER_BINS first + 2u);
    vec4 high_high = fetch_leaf_texel(BREWSTER_BINS first + 3u);
    float x = float(u - low_u) / float(high_u - low_u);
    float y = float(v - low_v) / float(high_v - low_v);
    vec3 low = vec3(low_low) + x * (vec3(high_low) - vec3(low_low));
    vec3 high = vec3(low_high) + x * (vec3(high_high) - vec3(low_high));
    BinValue result;
    result.value = max(low + y * (high - low), vec3(0.0f));
    result.standard_error = vec3(low_low.w, high_low.w, low_high.w);
    result.leaf = node.y & ~BREWSTER_NODE_LEAF;
    return result;
}
