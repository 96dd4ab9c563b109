#pragma once
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bins/snapshot.h"
#include "shared/bin_layout.h"

/// The C++ side of the one lookup; the formulas stand in shaders/shared/lookup.h.
namespace brewster::lookup {

using glm::clamp, glm::dot, glm::max, glm::min, glm::sqrt;
using glm::uvec2, glm::vec3, glm::vec4;
using uint = std::uint32_t;

inline uvec2 fetch_node(const Snapshot& bins, uint index) {
    return bins.nodes[index];
}
inline vec4 fetch_leaf_texel(const Snapshot& bins, uint index) {
    return bins.leaves[index];
}

inline uvec2 fetch_gloss_node(const Snapshot& bins, uint index) {
    return bins.gloss.nodes[index];
}
inline vec4 fetch_gloss_texel(const Snapshot& bins, uint index) {
    return bins.gloss.leaves[index];
}

#define BREWSTER_FUNCTION inline
#define BREWSTER_BINS_PARAMETER const Snapshot &bins,
#define BREWSTER_BINS bins,
#include "shared/gloss_lookup.h"
#include "shared/lookup.h"
#undef BREWSTER_FUNCTION
#undef BREWSTER_BINS_PARAMETER
#undef BREWSTER_BINS

}  // namespace brewster::lookup
