#pragma once
#include "display/gl_object.h"
#include "display/program.h"
#include "scene/scene.h"

namespace brewster {

/// What the interfaces of a scene's materials let out of their bases, as a picture for chart.frag: over the root of the
/// cosine, three rows (one a band) for each material; unpolarized share and s minus p share.
class PassageTable {
  public:
    explicit PassageTable(const Scene& scene);
    void bind(const Program& program, const char* uniform, int unit) const;

    /// For each unit that enters a base of albedo 1 without reflection from inside: 1/(pi n^2), 1/sr per band; and that
    /// reflection, Fi. Both zero where nothing enters.
    const std::vector<glm::vec3>& base_shares() const { return base_shares_; }
    const std::vector<glm::vec3>& internal_reflectances() const { return internal_reflectances_; }

  private:
    Texture texture_;
    std::vector<glm::vec3> base_shares_, internal_reflectances_;  // per material
};

}  // namespace brewster
