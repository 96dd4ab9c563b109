#pragma once
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
};

/// Three vertices a triangle and side that has a chart, counter-clockwise as seen from that side. Sides without a chart
/// are left out: one looks through the absorbing backs of a closed room into it.
std::vector<ChartVertex> chart_vertices(const Scene& scene);

/// The charts' triangles on the graphics side.
class ChartMesh {
  public:
    explicit ChartMesh(const Scene& scene);
    /// Draws all triangles that turn their front to the eye, with the current program (see chart.vert).
    void draw() const;

  private:
    VertexArray array_;
    Buffer buffer_;
    GLsizei vertex_count_ = 0;
};

}  // namespace brewster
