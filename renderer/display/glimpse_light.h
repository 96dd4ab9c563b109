#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "display/gl_object.h"
#include "display/program.h"
#include "image/stokes_picture.h"

namespace brewster {

/// A small picture of what bins cannot show, on the graphics side: chart.frag takes the light of the texels whose rays
/// have met the fragment's own chart.
class GlimpseLight {
  public:
    static constexpr int units = 6;  ///< texture units: charts, then the planes

    /// Row 0 on top; `chart`: per pixel, or 0xffffffff. Needs a current context.
    void upload(int width, int height, const std::vector<std::uint32_t>& chart,
                const std::array<std::vector<glm::vec3>, plane_count>& light);
    void clear() { width_ = height_ = 0; }
    bool shows() const { return width_ > 0; }

    /// Binds to `units` units from `first_unit` on, shows() or not; the frame is of so many pixels.
    void bind(const Program& program, int first_unit, int frame_width, int frame_height) const;

  private:
    int width_ = 0, height_ = 0;
    Texture chart_;
    std::array<Texture, plane_count> light_;
};

}  // namespace brewster
