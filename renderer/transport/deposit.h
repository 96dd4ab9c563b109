#pragma once
#include <glm/vec3.hpp>

#include "bins/file_event.h"
#include "scene/rays.h"

namespace brewster {

/// Files light that enters the base of the chart that was hit: the expected value, before any choice of survival.
/// Direct light is a photon's first hit.
inline void deposit(const BinTree<2>& tree, Tally<2>& tally, const Hit& hit, const glm::vec3& weight, bool direct,
                    std::uint32_t replica) {
    const BinTree<2>::Point point = {hit.u, hit.v};
    file_event<2>(tree, tally, tree.locate(hit.chart, point), point, weight, direct, replica);
}

}  // namespace brewster
