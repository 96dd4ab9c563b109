#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace brewster {

/// Sorts connected triangles of a plane, laid out counter-clockwise, into layers in which none lies on another: like
/// the turns of a spiral ramp seen from above. `neighbours`: pairs that share an edge; a layer grows along them. A
/// triangle lies on another if the middle of one is inside the other. Returns each triangle's layer, from 0.
std::vector<std::uint32_t> unfolded(const std::vector<std::array<glm::dvec2, 3>>& triangles,
                                    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& neighbours);

}  // namespace brewster
