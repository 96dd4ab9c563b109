#include "image/compare_polarization.h"

#include <cmath>
#include <complex>

#include "base/units.h"

namespace brewster {
namespace {

// The linear part of one band of one picture.
class LinearStokes {
  public:
    LinearStokes(const Image& image, int band)
        : s0_(image.channel(stokes_channel(0, band))),
          s1_(image.channel(stokes_channel(1, band))),
          s2_(image.channel(stokes_channel(2, band))) {
        const std::string v1 = variance_channel(1, band), v2 = variance_channel(2, band);
        if (!image.has(v1) || !image.has(v2)) return;
        v1_ = &image.channel(v1);
        v2_ = &image.channel(v2);
    }

    bool lit(std::size_t i) const { return s0_[i] > 0; }
    std::complex<double> vector(std::size_t i) const { return {s1_[i], s2_[i]}; }
    double dolp(std::size_t i) const { return std::abs(vector(i)) / static_cast<double>(s0_[i]); }
    bool has_angle(std::size_t i) const {
        const double noise = v1_ ? std::sqrt(0.5 * static_cast<double>((*v1_)[i] + (*v2_)[i])) : 0.0;
        return lit(i) && dolp(i) >= least_dolp_with_angle && std::abs(vector(i)) >= 3.0 * noise;
    }

  private:
    const std::vector<float>&s0_, &s1_, &s2_;
    const std::vector<float>*v1_ = nullptr, *v2_ = nullptr;
};

bool has_linear_stokes(const Image& image) {
    for (int band = 0; band < 3; ++band)
        for (int component = 0; component < 3; ++component)
            if (!image.has(stokes_channel(component, band))) return false;
    return true;
}

BandPolarization difference(const LinearStokes& a, const LinearStokes& b, std::size_t pixels,
                            std::span<const std::uint8_t> mask) {
    BandPolarization result;
    double lit = 0, squares = 0, angle_squares = 0;
    std::complex<double> turns = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if ((!mask.empty() && !mask[i]) || !a.lit(i) || !b.lit(i)) continue;
        const double dolp_a = a.dolp(i), dolp_b = b.dolp(i);
        lit += 1;
        result.mean_dolp_a += dolp_a;
        result.mean_dolp_b += dolp_b;
        squares += (dolp_a - dolp_b) * (dolp_a - dolp_b);
        if (!a.has_angle(i) || !b.has_angle(i)) continue;
        // S1 + i S2 turns by twice the angle, so the quotient's argument is twice the difference, on the half circle.
        const std::complex<double> turn = a.vector(i) * std::conj(b.vector(i));
        const double angle = degrees(0.5 * std::arg(turn));
        ++result.aolp_pixels;
        angle_squares += angle * angle;
        turns += turn / std::abs(turn);
    }
    if (lit > 0) {
        result.mean_dolp_a /= lit;
        result.mean_dolp_b /= lit;
        result.dolp_rmse = std::sqrt(squares / lit);
        result.dolp_bias = result.mean_dolp_a - result.mean_dolp_b;
    }
    if (result.aolp_pixels > 0) {
        result.aolp_rmse = std::sqrt(angle_squares / static_cast<double>(result.aolp_pixels));
        result.aolp_bias = degrees(0.5 * std::arg(turns));
    }
    return result;
}

}  // namespace

std::optional<std::array<BandPolarization, 3>> compare_polarization(const Image& a, const Image& b,
                                                                    std::span<const std::uint8_t> mask) {
    if (!has_linear_stokes(a) || !has_linear_stokes(b)) return {};
    std::array<BandPolarization, 3> bands;
    for (int band = 0; band < 3; ++band)
        bands[static_cast<std::size_t>(band)] =
            difference(LinearStokes(a, band), LinearStokes(b, band), a.pixel_count(), mask);
    return bands;
}

}  // namespace brewster
