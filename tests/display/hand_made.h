#pragma once
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>

#include "bins/snapshot.h"
#include "scene/scene.h"

namespace brewster::hand_made {

inline constexpr float pi_f = std::numbers::pi_v<float>;

/// Adds a rectangle of two triangles: one corner, two edges in metres, counter-clockwise as seen from its front.
/// Returns its front chart.
std::uint32_t add_rectangle(Scene& scene, glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v,
                            const Material& material, bool double_sided = false);

/// Bounds and centre of what was added; coordinates stay.
void close(Scene& scene);

/// Bins with one leaf a chart for the direct and one for the indirect light.
Snapshot empty_bins(const Scene& scene);

/// Appends a leaf with these corner values (0,0), (1,0), (0,1), (1,1) and standard error, equal in all bands up
/// to the factors 1, 1/2, 1/4, and returns the word that a node needs for it.
glm::uvec2 add_leaf(Snapshot& bins, const std::array<float, 4>& corners, float standard_error);

/// Appends a random tree of about so many leaves: uneven splits along both axes, random corners in [1, 10]. Returns
/// its root.
std::uint32_t add_random_tree(Snapshot& bins, int leaves, std::mt19937& random);

}  // namespace brewster::hand_made
