#pragma once
#include <cstdint>

#include "scene/scene.h"

namespace brewster {

/// A hit by triangle and barycentric coordinates of its second and third corner.
struct TriangleHit {
    std::uint32_t triangle = no_chart;  ///< no_chart: nothing was met
    float distance = 0, b1 = 0, b2 = 0;

    bool met() const { return triangle != no_chart; }
};

}  // namespace brewster
