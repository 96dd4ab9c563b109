#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// A narrow rectangle along an edge of a triangle that no other triangle shares bit by bit: `corners` in order.
struct Seam {
    std::array<glm::vec3, 4> corners;
    std::uint32_t triangle = 0;
};

/// Where surfaces meet without sharing vertices (a wall that ends within another's edge), rounding leaves gaps of a few
/// units in the last place, and one ray in 1e7 finds them. Seams cover such edges on both sides, as wide as hits are
/// pulled inside; a ray that meets nothing else is asked against them.
std::vector<Seam> open_seams(const Scene& scene);

}  // namespace brewster
