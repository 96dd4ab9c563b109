#pragma once
#include <algorithm>
#include <cmath>

namespace brewster {

/// The ratio of two sums over the same independent samples, and its standard error by the delta method: the spread of
/// x - ratio y over the sum of y. What x and y share cancels.
class PairedRatio {
  public:
    void add(double x, double y) {
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
        yy_ += y * y;
    }
    void add(const PairedRatio& other) {
        x_ += other.x_;
        y_ += other.y_;
        xx_ += other.xx_;
        xy_ += other.xy_;
        yy_ += other.yy_;
    }

    double value() const { return y_ > 0 ? x_ / y_ : 0; }  ///< 0 where nothing was added
    double standard_error() const {
        if (!(y_ > 0)) return 0;
        const double spread = xx_ - 2 * value() * xy_ + value() * value() * yy_;
        return std::sqrt(std::max(spread, 0.0)) / y_;
    }

  private:
    double x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
};

}  // namespace brewster
