#pragma once
#include <array>

#include "base/lanes.h"

namespace brewster {

/// A Stokes vector in a frame that its owner knows (conventions.h). One component: the unpolarized intensity alone.
/// Three: no circular part can arise. Four: all. Absent components read as zero. Bands are an array of these.
template <class Real, int components>
struct Stokes {
    static_assert(components == 1 || components == 3 || components == 4);
    std::array<Real, components> s{};

    const Real& operator[](int j) const { return s[static_cast<unsigned>(j)]; }
    Real& operator[](int j) { return s[static_cast<unsigned>(j)]; }

    Real s0() const { return s[0]; }
    Real s1() const { return component<1>(); }
    Real s2() const { return component<2>(); }
    Real s3() const { return component<3>(); }

    /// Beams add only if they are mutually incoherent and share a frame.
    friend Stokes operator+(Stokes a, const Stokes& b) {
        for (int j = 0; j < components; ++j) a[j] = a[j] + b[j];
        return a;
    }
    friend Stokes operator*(const Real& scale, Stokes a) {
        for (int j = 0; j < components; ++j) a[j] = scale * a[j];
        return a;
    }

  private:
    template <int j>
    Real component() const {
        if constexpr (j < components)
            return s[j];
        else
            return Real(0);
    }
};

/// Keeps the components that the target has: the way to write one formula for 1, 3 and 4 components.
template <int components, class Real>
Stokes<Real, components> stokes_of(const Real& s0, const Real& s1, const Real& s2, const Real& s3) {
    if constexpr (components == 1)
        return {{s0}};
    else if constexpr (components == 3)
        return {{s0, s1, s2}};
    else
        return {{s0, s1, s2, s3}};
}

template <int components, class Real>
Stokes<Real, components> unpolarized(const Real& s0) {
    return stokes_of<components>(s0, Real(0), Real(0), Real(0));
}

/// sqrt(S1^2 + S2^2): the linearly polarized intensity.
template <class Real, int components>
Real linear_intensity(const Stokes<Real, components>& light) {
    return sqrt(fma(light.s1(), light.s1(), light.s2() * light.s2()));
}

/// sqrt(S1^2 + S2^2 + S3^2): the polarized intensity.
template <class Real, int components>
Real polarized_intensity(const Stokes<Real, components>& light) {
    return sqrt(fma(light.s1(), light.s1(), fma(light.s2(), light.s2(), light.s3() * light.s3())));
}

/// part / S0, and 0 in the dark.
template <class Real>
Real degree(const Real& part, const Real& s0) {
    return select(s0 > 0, part / select(s0 > 0, s0, Real(1)), Real(0));
}

/// Degrees of polarization, of linear and of circular polarization, in [0, 1] for realizable light; 0 in the dark.
template <class Real, int components>
Real dop(const Stokes<Real, components>& light) {
    return degree(polarized_intensity(light), light.s0());
}
template <class Real, int components>
Real dolp(const Stokes<Real, components>& light) {
    return degree(linear_intensity(light), light.s0());
}
template <class Real, int components>
Real docp(const Stokes<Real, components>& light) {
    return degree(abs(light.s3()), light.s0());
}

/// S0 >= 0 and S0^2 >= S1^2 + S2^2 + S3^2, up to `slack` relative to S0.
template <class Real, int components>
auto realizable(const Stokes<Real, components>& light, const Real& slack) {
    return light.s0() >= 0 && polarized_intensity(light) <= light.s0() * (1 + slack);
}

/// Shortens (S1, S2, S3) to S0 where rounding has made them longer; leaves all other light alone.
template <class Real, int components>
Stokes<Real, components> made_realizable(const Stokes<Real, components>& light) {
    const Real length = polarized_intensity(light);
    const auto longer = length > light.s0();
    const Real scale = select(longer, light.s0() / select(longer, length, Real(1)), Real(1));
    return stokes_of<components>(light.s0(), scale * light.s1(), scale * light.s2(), scale * light.s3());
}

}  // namespace brewster
