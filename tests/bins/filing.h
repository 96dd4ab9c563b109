#pragma once
#include <glm/vec3.hpp>

#include "bins/file_event.h"

namespace brewster {

/// Files light that is the same in both worlds, by a tree of plain records.
template <int D>
void file_light(const BinTree<D>& tree, Tally<D>& tally, std::uint32_t leaf, const typename BinTree<D>::Point& point,
                const glm::vec3& weight, bool direct, std::uint32_t replica) {
    file_event<D>(tree, tally, leaf, point, {D == 2 && !direct ? 1 : 0, 0, {&weight.x, 3}, replica});
}

}  // namespace brewster
