#pragma once

namespace brewster {

/// Whether pictures of a moving camera are drawn at half the resolution: once a full one took longer than 60 ms, until
/// a half one takes less than 12 ms, when a full one would take well under 60.
class MotionResolution {
  public:
    bool half() const { return half_; }
    void frame_took(double seconds) {
        if (!half_ && seconds > 0.060) {
            half_ = true;
        } else if (half_ && seconds < 0.012) {
            half_ = false;
        }
    }

  private:
    bool half_ = false;
};

}  // namespace brewster
