#pragma once
#include <cmath>

namespace brewster {

/// Sine and cosine of a whole turn's fraction, without the C library, so that scalar and vector code give the same bits.
template <class Real>
struct SineCosine {
    Real sine, cosine;
};

/// sin and cos of 2 pi turns, turns in [0, 1). Absolute error below 2e-7 in float.
/// Reduction to an eighth of a turn is exact; Taylor polynomials on [-pi/4, pi/4].
inline SineCosine<float> sincos_turns(float turns) {
    const float quarter = std::floor(turns * 4.0f + 0.5f);
    const float x = (turns * 4.0f - quarter) * 1.57079632679489662f;
    const float xx = x * x;
    const float s = std::fma(std::fma(std::fma(std::fma(2.7557319e-6f, xx, -1.9841270e-4f), xx, 8.3333333e-3f), xx, -1.6666667e-1f) * xx, x, x);
    const float c = std::fma(std::fma(std::fma(std::fma(2.4801587e-5f, xx, -1.3888889e-3f), xx, 4.1666667e-2f), xx, -0.5f), xx, 1.0f);
    const int q = static_cast<int>(quarter) & 3;
    const float sine = (q & 1) ? c : s;
    const float cosine = (q & 1) ? s : c;
    return {(q & 2) ? -sine : sine, (q == 1 || q == 2) ? -cosine : cosine};
}

}  // namespace brewster
