#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace brewster {

/// Trees of one chart: their roots among the nodes, their leaves.
struct ChartBins {
    std::uint32_t direct_root = 0, indirect_root = 0;
    std::uint32_t direct_leaves = 0, indirect_leaves = 0;
};

/// The bins of one moment, immutable, in the layout of shaders/shared/bin_layout.h.
struct Snapshot {
    std::uint64_t version = 0;  ///< grows with every publication
    std::uint64_t photons = 0;  ///< emitted so far
    std::vector<glm::uvec2> nodes;
    std::vector<glm::vec4> leaves;
    std::vector<ChartBins> charts;
    double relative_error = 0;  ///< area-weighted rms of the relative standard error
};

}  // namespace brewster
