#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "optics/vector.h"

namespace brewster {

/// A triangle as a point sees it, on the sphere of directions.
class SphericalTriangle {
  public:
    /// From the point to the corners, of any lengths but zero.
    explicit SphericalTriangle(const std::array<Vector<double>, 3>& to_corners)
        : a_(normalized(to_corners[0])), b_(normalized(to_corners[1])), c_(normalized(to_corners[2])) {
        const Vector<double> across_b = cross(a_, b_), across_c = cross(a_, c_);
        const double determinant = std::abs(dot(a_, cross(b_, c_)));
        angle_ = std::atan2(determinant, dot(across_b, across_c));
        solid_angle_ = 2 * std::atan2(determinant, 1 + dot(a_, b_) + dot(b_, c_) + dot(c_, a_));
    }

    /// Steradian (Van Oosterom and Strackee 1983); next to none where the point lies in the triangle's plane, outside.
    double solid_angle() const { return solid_angle_; }

    /// Evenly spread directions from two numbers in [0, 1) (Arvo, Stratified sampling of spherical triangles, 1995). Of
    /// triangles with a solid angle well above rounding.
    Vector<double> sample(double u, double v) const {
        const double cos_a = std::cos(angle_), sin_a = std::sin(angle_), cos_c = dot(a_, b_);
        const double rest = u * solid_angle_ - angle_, s = std::sin(rest), t = std::cos(rest);
        const double p = t - cos_a, q = s + sin_a * cos_c;
        const double denominator = (q * s + p * t) * sin_a;
        const double cosine =
            denominator != 0 ? std::clamp(((q * t - p * s) * cos_a - q) / denominator, -1.0, 1.0) : 1.0;
        const Vector<double> side = cosine * a_ + std::sqrt(1 - cosine * cosine) * part_across(c_, a_);
        const double z = 1 - v * (1 - dot(side, b_));
        return normalized(z * b_ + std::sqrt(std::max(0.0, 1 - z * z)) * part_across(side, b_));
    }

  private:
    // The unit vector across `axis` in the plane of both; zero if they are parallel.
    static Vector<double> part_across(const Vector<double>& v, const Vector<double>& axis) {
        const Vector<double> part = v - dot(v, axis) * axis;
        const double length = std::sqrt(dot(part, part));
        return length > 0 ? (1 / length) * part : part;
    }

    Vector<double> a_, b_, c_;
    double angle_ = 0;  // at a
    double solid_angle_ = 0;
};

}  // namespace brewster
