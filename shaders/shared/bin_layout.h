// Layout of the published bins, read by C++ and GLSL alike.
//
// Chart coordinates are fixed point: u and v of [0, 1) times 2^24, so that both sides descend by integer compares.
// Node, two words:  inner: x = split position, y = axis << 29 | index of the low child (the high child follows it);
//                   leaf:  x = 0,              y = 1 << 31 | index of the leaf.
// Leaf, four texels of four floats: the values at the corners (u,v) = (0,0), (1,0), (0,1), (1,1), each red, green,
// blue; the fourth floats of the first three texels hold the standard error of red, green, blue, the last is zero.
// Between the corners the value is bilinear. Values are entered flux per area: irradiance, in lux.
// Where the polarized and the unpolarized world differ, the leaf of the unpolarized one stands behind the node's.
//
// Chart, two words: root node of the direct light, root node of the indirect light.

#define BREWSTER_UV_BITS 24
#define BREWSTER_UV_ONE 16777216u
#define BREWSTER_NODE_LEAF 0x80000000u
#define BREWSTER_NODE_AXIS_SHIFT 29
#define BREWSTER_NODE_INDEX 0x1fffffffu
#define BREWSTER_LEAF_TEXELS 4u
