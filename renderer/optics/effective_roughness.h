#pragma once
#include "optics/lambert_w.h"
#include "optics/shadowing.h"

/// The rms height of the part of a surface that is lit and seen (thesis 6.40, 6.41; He et al. 1991, 80 to 83).
namespace brewster {

/// K of He et al. for one direction: tan(theta) erfc(h), h = cot(theta)/m; 1/4 comes in once, below.
/// cos_theta > 0 (clamped at 1e-12).
template <class Real>
Real excess_slope_he(const Real& cos_theta, const Real& m) {
    const Real tangent = sqrt((1 - cos_theta) * (1 + cos_theta)) / max(cos_theta, constant<Real>(1e-12));
    return tangent * erfc(min(cotangent_over_slope(cos_theta, m), Real(30)));
}

/// The consistent K: 2 Lambda, what the height density exp(-z^2/2s^2 - (Lambda_i + Lambda_r) Q(z/s)) of lit and seen
/// points asks for. He's K puts the probability for the mean excess slope and is 2 to 60 times larger.
template <class Real>
Real excess_slope_smith(const Real& cos_theta, const Real& m) {
    return 2 * smith_lambda(max(cotangent_over_slope(cos_theta, m), constant<Real>(1e-12)));
}

/// Mean height of the lit and seen points and their rms height, both over the surface's own rms height.
template <class Real>
struct EffectiveRoughness {
    Real mean_height, sigma_ratio;
};

/// x = z0/sigma0 solves x exp(x^2/2) = q = (K_i + K_r)/sqrt(8 pi), hence x^2 = W(q^2) and sigma/sigma0 = 1/sqrt(1 + W):
/// the closed form of the thesis's iteration (7.56). excess_slopes = K_i + K_r >= 0.
template <class Real>
EffectiveRoughness<Real> effective_roughness(const Real& excess_slopes) {
    constexpr double smallest = std::is_same_v<Real, double> ? 1e-9 : 1e-4;  // below it x = q to the last digit
    const Real q = constant<Real>(0.19947114020071635) * excess_slopes;      // 1/sqrt(8 pi)
    const auto tiny = q < constant<Real>(smallest);
    const Real w = select(tiny, q * q, lambert_w_of_log(2 * log(max(q, constant<Real>(smallest)))));
    return {select(tiny, q, sqrt(w)), 1 / sqrt(1 + w)};
}

}  // namespace brewster
