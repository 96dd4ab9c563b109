#pragma once
#include <span>

#include "bins/file_event.h"
#include "scene/rays.h"

namespace brewster {

/// Files light that enters the base of the chart that was hit: the expected value, before any choice of survival.
/// `weights`: of as many worlds as the tree tells apart for this light, polarized first, per band. Direct light is a
/// photon's first hit.
inline void deposit(const BinTree<2>& tree, const EntryFields& fields, Tally<2>& tally, const Hit& hit,
                    std::span<const float> weights, bool direct, std::uint32_t replica) {
    const BinTree<2>::Point point = {hit.u, hit.v};
    const int light = direct ? 0 : 1;
    const Arrival arrival{fields.field(light, 0), direct ? 0 : fields.direct_worlds - 1, weights, replica};
    file_event<2>(tree, tally, tree.locate(hit.chart, point), point, arrival);
}

}  // namespace brewster
