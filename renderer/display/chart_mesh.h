#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "display/gl_object.h"
#include "scene/scene.h"

namespace brewster {

struct ChartVertex {
    glm::vec3 position;
    glm::vec2 unit_coordinates;
    std::uint32_t chart;
    glm::vec2 texture_coordinates{0.0f};
    std::array<std::uint16_t, 4> color{65535, 65535, 65535, 65535};  ///< linear
};

/// Vertices that stand together and share a texture of the scene.
struct ChartGroup {
    std::uint32_t texture = no_texture;
    GLint first = 0;
    GLsizei count = 0;
};

/// Three vertices a triangle and side that has a chart, counter-clockwise as seen from that side. Sides without a chart
/// are left out: one looks through the absorbing backs of a closed room into it. Textures stand together.
std::vector<ChartVertex> chart_vertices(const Scene& scene);
std::vector<ChartGroup> chart_groups(const Scene& scene, const std::vector<ChartVertex>& vertices);

/// The charts' triangles on the graphics side.
class ChartMesh {
  public:
    explicit ChartMesh(const Scene& scene);
    /// Draws the triangles of a group that turn their front to the eye, with the current program (see chart.vert).
    void draw(const ChartGroup& group) const;
    const std::vector<ChartGroup>& groups() const { return groups_; }

  private:
    VertexArray array_;
    Buffer buffer_;
    std::vector<ChartGroup> groups_;
};

}  // namespace brewster
