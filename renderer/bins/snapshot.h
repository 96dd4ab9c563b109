#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "shared/bin_layout.h"

namespace brewster {

/// Trees of one chart: their roots among the nodes, their leaves.
struct ChartBins {
    std::uint32_t direct_root = 0, indirect_root = 0;
    std::uint32_t direct_leaves = 0, indirect_leaves = 0;
};

inline constexpr std::uint32_t no_root = 0xffffffffu;

/// The trees of gloss, over position and direction.
struct GlossBins {
    std::vector<glm::uvec2> nodes;
    std::vector<glm::vec4> leaves;
    std::vector<std::uint32_t> roots;  ///< per chart of the scene; no_root where gloss is not filed
    int components = 1;                ///< of the Stokes vector: 1, 3 or 4

    int fields() const { return components > 1 ? components + 1 : 1; }
    std::size_t leaf_count() const {
        return leaves.size() / (BREWSTER_GLOSS_FIELD_TEXELS * static_cast<std::size_t>(fields()));
    }
};

/// The bins of one moment, immutable, in the layout of shaders/shared/bin_layout.h.
struct Snapshot {
    std::uint64_t version = 0;  ///< grows with every publication
    std::uint64_t photons = 0;  ///< emitted so far
    std::vector<glm::uvec2> nodes;
    std::vector<glm::vec4> leaves;
    std::vector<ChartBins> charts;
    GlossBins gloss;
    /// How many worlds' values a leaf of the direct and of the indirect light holds: polarized, then unpolarized, or one
    /// where both are the same.
    int direct_worlds = 1, indirect_worlds = 1;
    double relative_error = 0;  ///< area-weighted rms of the relative standard error, where it is lit

    /// What `look_up` adds to a leaf's index to reach a world's values (0 polarized, 1 unpolarized).
    std::uint32_t direct_offset(int world) const { return direct_worlds == 2 && world == 1 ? 1u : 0u; }
    std::uint32_t indirect_offset(int world) const { return indirect_worlds == 2 && world == 1 ? 1u : 0u; }
};

}  // namespace brewster
