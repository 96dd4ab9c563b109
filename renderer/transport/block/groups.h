#pragma once
#include <cstdint>
#include <vector>

#include "transport/context.h"

namespace brewster::transport {

/// Photons that meet one material on one side, or one filter sheet: what lanes have in common.
struct Group {
    const PreparedMaterial* material = nullptr;
    bool inside = false;  ///< of a closed transparent body
    bool gloss = false;   ///< files over position and direction, too,
    bool coarse = false;  ///< whatever its lobe is
    Vector<float> filter_axis;
    std::vector<std::uint32_t> slots;
};

/// All groups of a scene, and which one a chart belongs to.
struct Groups {
    explicit Groups(const TransportContext& context);

    std::vector<Group> groups;
    std::vector<std::uint32_t> of_chart;
};

}  // namespace brewster::transport
