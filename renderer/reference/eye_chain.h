#pragma once
#include "base/units.h"
#include "optics/mueller.h"
#include "optics/planar_mueller.h"

namespace brewster {

/// What the camera sees of light that arrives at the far end of an eye path: a product of Mueller matrices in light
/// order, a band each, growing at the lamp's end. Polarization off (1 component): of unpolarized reflectances.
template <int components>
class EyeChain;

template <>
class EyeChain<4> {
  public:
    EyeChain() {
        for (Mueller<double>& matrix : bands_)
            for (unsigned j = 0; j < 4; ++j) matrix.m[j][j] = 1;
    }

    /// Light first meets `event`, then changes frame by `turn`, then goes on as before.
    void prepend(const std::array<PlanarMueller<double>, band_count>& event, const FrameRotation<double>& turn) {
        for (std::size_t band = 0; band < band_count; ++band) {
            const PlanarMueller<double>& e = event[band];
            for (std::array<double, 4>& row : bands_[band].m) {
                const double s1 = row[1] * turn.cos_2t - row[2] * turn.sin_2t;
                const double s2 = row[1] * turn.sin_2t + row[2] * turn.cos_2t;
                row = {row[0] * e.m00 + s1 * e.m10, row[0] * e.m01 + s1 * e.m11, s2 * e.c + row[3] * e.d,
                       row[3] * e.c - s2 * e.d};
            }
        }
    }

    Stokes<double, 4> seen(std::size_t band, const Stokes<double, 4>& light) const { return bands_[band] * light; }

    /// Of unpolarized light: the largest S0 of the bands.
    double largest() const { return std::max(bands_[0].m[0][0], std::max(bands_[1].m[0][0], bands_[2].m[0][0])); }

    void scale(double by) {
        for (Mueller<double>& matrix : bands_)
            for (std::array<double, 4>& row : matrix.m)
                for (double& element : row) element *= by;
    }

  private:
    std::array<Mueller<double>, band_count> bands_{};
};

template <>
class EyeChain<1> {
  public:
    void prepend(const std::array<PlanarMueller<double>, band_count>& event, const FrameRotation<double>&) {
        for (std::size_t band = 0; band < band_count; ++band) bands_[band] *= event[band].m00;
    }
    Stokes<double, 1> seen(std::size_t band, const Stokes<double, 1>& light) const { return bands_[band] * light; }
    double largest() const { return std::max(bands_[0], std::max(bands_[1], bands_[2])); }
    void scale(double by) {
        for (double& band : bands_) band *= by;
    }

  private:
    std::array<double, band_count> bands_ = {1, 1, 1};
};

}  // namespace brewster
