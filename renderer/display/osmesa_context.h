#pragma once
#include <array>
#include <cstddef>

namespace brewster {

/// OpenGL 3.3 core without a display, drawn by the processor. Current on the constructing thread while it lives;
/// pictures are drawn into framebuffer objects, its own buffer is a token.
class OsmesaContext {
  public:
    OsmesaContext();  ///< throws Error when the driver is missing or too old
    ~OsmesaContext();
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

  private:
    static constexpr int side = 16;
    std::array<std::byte, 4 * side * side> buffer_{};
    void* context_ = nullptr;
};

}  // namespace brewster
