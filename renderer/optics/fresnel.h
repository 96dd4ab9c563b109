#pragma once
#include <type_traits>

#include "optics/mueller.h"
#include "optics/twofold.h"

namespace brewster {

template <class Real>
struct Complex {
    Real re, im;
};

/// A plane interface between media of real index, met at one angle. All are relative to the incident light; see
/// conventions.h for the signs. Beyond the critical angle Rs = Rp = 1 and nothing is transmitted.
template <class Real>
struct DielectricInterface {
    Complex<Real> rs, rp;  ///< amplitude reflection
    Real Rs, Rp;           ///< power reflection, in [0, 1]
    Real ts, tp;           ///< amplitude transmission
    Real Ts, Tp;           ///< power transmission, with the factor n_t cos t / (n_i cos i)
    Real cos_theta_t;      ///< 0 beyond the critical angle
    InterfaceMueller<Real> reflection, transmission;
};

/// Fresnel's formulas without trigonometry, for cos_theta_i in [0, 1] and eta_t_over_i = n_t / n_i in [1e-3, 1e3].
/// u = n cos(theta_t) from u^2 = n^2 + c^2 - 1, rs = (1 - n^2)/(c + u)^2, and rp = -rs (cu - s^2)/(cu + s^2), an
/// identity of n^2 c +- u = (u +- c)(cu +- s^2). Nothing cancels as n -> 1, at Brewster's angle, or at the critical
/// angle, where tan(Delta/2) = c q / s^2, u = -i q, gives the phase of total reflection (Born and Wolf 1.5.4). Double:
/// relative error below 1e-14 in every field. Float: absolute error below 2e-6, Rs Rp Ts Tp relative below 1e-5.
template <class Real>
[[gnu::always_inline]] inline DielectricInterface<Real> dielectric_interface(const Real& cos_theta_i,
                                                                             const Real& eta_t_over_i) {
    // Forced inline, here and in frame.h and beckmann.h: what a caller does not use is then not computed.
    const Real c = cos_theta_i, n = eta_t_over_i;
    const Real half = constant<Real>(0.5);
    const Real s2 = (1 - c) * (1 + c);
    const Twofold<Real> n2 = two_product(n, n), c2 = two_product(c, c), cn = two_product(c, n);
    const Twofold<Real> u2_twofold = sum_minus_one(n2, c2);
    const Twofold<Real> f = sum_minus_one(square(cn), c2);  // (c u)^2 - s^4, zero at Brewster's angle
    const Real u2 = u2_twofold.hi;
    const auto total = u2 < 0;
    const Real root = sqrt(abs(u2));
    const Real u = select(total, Real(0), root);  // Re u
    const Real q = select(total, root, Real(0));  // -Im u
    const Real one_minus_n2 = (1 - n) * (1 + n);

    const Real cu = c * u, cq = c * q;
    const Real a = c + u, b = cu + s2;
    const Real a2 = fma(a, a, q * q);    // |c + u|^2
    const Real b2 = fma(b, b, cq * cq);  // |cu + s^2|^2
    // Vanishes only at grazing incidence on n = 1, where there is no interface.
    const auto absent = a2 < constant<Real>(1e-37);
    const Real safe_a2 = select(absent, Real(1), a2);
    const Real inv = 1 / (safe_a2 * b2);
    const Real inv_a2 = inv * b2, inv_b2 = inv * safe_a2;

    const Real rs_scale = one_minus_n2 * inv_a2;
    DielectricInterface<Real> at;
    const Real bounded_rs = select(absent, Real(0), max(min(rs_scale, Real(1)), Real(-1)));
    const Real ratio = select(total, Real(1), max(min(f.hi * inv_b2, Real(1)), Real(-1)));  // -rp / rs
    const Real Rs = select(total, Real(1), bounded_rs * bounded_rs);
    const Real Rp = Rs * (ratio * ratio);
    const Real b_reflected = 2 * (cu * s2) * (Rs * inv_b2);
    // C + i D = conj(rs) rp = -Rs (cu - s^2)/(cu + s^2).
    Real tir_c = (s2 - cq) * (s2 + cq) * inv_b2;
    if constexpr (std::is_same_v<Real, double>) {  // relative accuracy through its zero, for the oracle
        const Twofold<Real> s4 = square(Twofold<Real>{1, 0} + Twofold<Real>{-c2.hi, -c2.lo});
        tir_c = (f + Twofold<Real>{2 * s4.hi, 2 * s4.lo}).hi * inv_b2;
    }
    const Real tir_d = 2 * (cq * s2) * inv_b2;
    at.Rs = Rs;
    at.Rp = Rp;
    at.reflection = {half * (Rs + Rp), b_reflected, select(total, tir_c, -Rs * ratio), select(total, tir_d, Real(0))};

    // 1/(c - iq)^2 = (c + iq)^2 / |.|^4, and the same with c q and s^2 for rp.
    const Real rs_re = sum_minus_one(n2, Twofold<Real>{2 * c2.hi, 2 * c2.lo}).hi * inv_a2, rs_im = 2 * cq * inv_a2;
    at.rs = {select(total, rs_re, bounded_rs), select(total, rs_im, Real(0))};
    const Twofold<Real> n2c{n2.hi * c, fma(n2.hi, c, -n2.hi * c) + n2.lo * c};
    const Real inv_p = 1 / select(total, fma(n2c.hi, n2c.hi, q * q), Real(1));
    at.rp = {select(total, (square(n2c) + u2_twofold).hi * inv_p, -bounded_rs * ratio),
             select(total, 2 * n2c.hi * q * inv_p, Real(0))};

    const Real n_over_b = n / b;
    at.ts = select(total, Real(0), select(absent, Real(1), 2 * c / select(absent, Real(1), a)));
    at.tp = at.ts * n_over_b;
    at.Ts = select(total, Real(0), select(absent, Real(1), min(4 * cu * inv_a2, Real(1))));
    at.Tp = min(at.Ts * (n_over_b * n_over_b), Real(1));
    at.cos_theta_t = min(u / n, Real(1));
    at.transmission = {half * (at.Ts + at.Tp), -b_reflected, at.Ts * n_over_b, Real(0)};
    return at;
}

/// A plane surface of an absorbing medium.
template <class Real>
struct ConductorInterface {
    Complex<Real> rs, rp;
    Real Rs, Rp;
    InterfaceMueller<Real> reflection;
};

/// Relative index n - i k under exp(+i w t), n > 0, k >= 0 both relative to the incident medium, at most 1e3.
/// The same formulas as for a dielectric with a complex u = sqrt(N^2 - s^2) (Born and Wolf 14.2, conjugated).
/// Double: Rs, Rp to a relative 1e-12, amplitudes and matrix elements to 2e-15.
/// Float: 2e-6.
template <class Real>
[[gnu::always_inline]] inline ConductorInterface<Real> conductor_interface(const Real& cos_theta_i, const Real& n,
                                                                           const Real& k) {
    const Real c = cos_theta_i;
    const Real half = constant<Real>(0.5);
    const Real s2 = (1 - c) * (1 + c);
    const Twofold<Real> c2 = two_product(c, c);
    const Real x = fma(-k, k, sum_minus_one(two_product(n, n), c2).hi);  // Re N^2 - s^2
    const Real nk = n * k;
    const Real h = sqrt(fma(x, x, 4 * nk * nk));
    const Real major = sqrt(half * (h + abs(x)));
    const Real minor = nk / select(major > 0, major, Real(1));
    const Real u_re = select(x < 0, minor, major), u_im = select(x < 0, major, minor);  // u = u_re - i u_im

    // rs = (1 - N^2)/(c + u)^2
    const Real w_re = fma(k, k, (1 - n) * (1 + n)), w_im = 2 * nk;
    const Real a_re = c + u_re, a_im = u_im;              // c + u = a_re - i a_im
    const Real b_re = fma(c, u_re, s2), b_im = c * u_im;  // cu + s^2 = b_re - i b_im
    // Both vanish only where there is no interface, n = 1, k = 0, at grazing incidence.
    const Real a2 = max(fma(a_re, a_re, a_im * a_im), constant<Real>(1e-18));
    const Real b2 = max(fma(b_re, b_re, b_im * b_im), constant<Real>(1e-18));
    const Real inv = 1 / (a2 * b2);
    const Real inv_a2 = inv * b2, inv_b2 = inv * a2;
    const Real inv_re = (a_re - a_im) * (a_re + a_im) * inv_a2, inv_im = 2 * a_re * a_im * inv_a2;
    const Complex<Real> rs{fma(w_re, inv_re, -w_im * inv_im) * inv_a2, fma(w_re, inv_im, w_im * inv_re) * inv_a2};

    // rp = -rs g, g = (cu - s^2)/(cu + s^2) = (c^2 N^2 - s^2)/(cu + s^2)^2
    const Real ck = c * k;
    const Real f_re = fma(-ck, ck, sum_minus_one(square(two_product(c, n)), c2).hi), f_im = -2 * (c * c) * nk;
    const Real q_re = (b_re - b_im) * (b_re + b_im) * inv_b2, q_im = 2 * b_re * b_im * inv_b2;
    const Complex<Real> g{fma(f_re, q_re, -f_im * q_im) * inv_b2, fma(f_re, q_im, f_im * q_re) * inv_b2};

    const Real Rs = min(fma(w_re, w_re, w_im * w_im) * (inv_a2 * inv_a2), Real(1));
    const Real Rp = min(Rs * (fma(f_re, f_re, f_im * f_im) * (inv_b2 * inv_b2)), Real(1));
    const Real scale = Rs * inv_b2;
    const Real cu2 = c * c * fma(u_re, u_re, u_im * u_im);
    ConductorInterface<Real> at;
    at.rs = rs;
    at.rp = {fma(-rs.re, g.re, rs.im * g.im), fma(-rs.re, g.im, -rs.im * g.re)};
    at.Rs = Rs;
    at.Rp = Rp;
    // (cu - s^2) conj(cu + s^2) = |cu|^2 - s^4 - 2 i s^2 c u_im
    at.reflection = {half * (Rs + Rp), 2 * s2 * c * u_re * scale, fma(s2, s2, -cu2) * scale, 2 * s2 * c * u_im * scale};
    return at;
}

/// The reflection matrix of either interface in the frame of the plane of incidence.
template <class Real>
[[gnu::always_inline]] inline InterfaceMueller<Real> mueller_reflection(const Real& cos_theta_i,
                                                                        const Real& eta_t_over_i) {
    return dielectric_interface(cos_theta_i, eta_t_over_i).reflection;
}
template <class Real>
[[gnu::always_inline]] inline InterfaceMueller<Real> mueller_reflection(const Real& cos_theta_i, const Real& n,
                                                                        const Real& k) {
    return conductor_interface(cos_theta_i, n, k).reflection;
}

/// M_R turned into the carried frame: the corrected thesis (7.61), with its factor 1/2 and the sign of sin 2t.
template <class Real>
Mueller<Real> mueller_reflection_from_carried_frame(const InterfaceMueller<Real>& event,
                                                    const FrameRotation<Real>& turn) {
    return full_matrix(event) * frame_matrix(turn);
}

}  // namespace brewster
