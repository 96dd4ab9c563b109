#pragma once
#include <array>

#include "optics/beckmann.h"

/// Gloss of wave optics, model E1R: a mirror ray of strength e^-g and, for each order n >= 1 of a Poisson law of mean
/// g = (4 pi sigma cos_i / lambda)^2, a Beckmann lobe of slope m sqrt(n/g), the n-th term of the Kirchhoff series with
/// v_z frozen at the mirror direction. Made reciprocal by the smaller of both directions of use.
namespace brewster {

inline constexpr std::size_t order_nodes = 5;

/// The orders n >= 1 by a few nodes with weights that add up to 1, as g/n.
template <class Real>
struct OrderNodes {
    std::array<Real, order_nodes> root, weight;
};

/// Gauss rules of the Poisson law given n >= 1, in the variable 1/n, which the lobes are smooth in: five nodes stay
/// within 1e-3 of the whole series, relative to the lobe's peak, at every g. One table for all materials and colours.
class OrderRules {
  public:
    OrderRules();

    /// g >= 0; above 1e4 the rule of 1e4 is used, whose orders vary by 1 %.
    template <class Real>
    OrderNodes<Real> at(const Real& g) const {
        const Real root = min(sqrt(g), constant<Real>(largest_root));
        const Real position = root / (root + constant<Real>(knee)) * constant<Real>(rows_per_unit);
        const Real index = min(floor(position), constant<Real>(rows - 2));
        const Real fraction = position - index;
        const auto row = blend_rows<Real>(table_.data(), index, fraction);
        OrderNodes<Real> nodes;
        const Real scale = sqrt(g / (1 + g));
        for (std::size_t j = 0; j < order_nodes; ++j) {
            nodes.root[j] = scale * row[j];
            nodes.weight[j] = row[order_nodes + j];
        }
        return nodes;
    }

  private:
    // Rows evenly in v/(v + knee), v = sqrt(g): sqrt((1 + g)/n) of each node, the weights, and what fills whole rows of eight.
    static constexpr double largest_root = 100, knee = 4;
    static constexpr int rows = 512;
    static constexpr double rows_per_unit = (rows - 1) * (largest_root + knee) / largest_root;
    static constexpr std::size_t columns = 16;
    std::array<std::array<float, columns>, rows> table_{};
};

/// A Kirchhoff surface at `bands` wavelengths.
template <class Real, std::size_t bands>
struct KirchhoffSurface {
    Real m;                         ///< 2 sigma / tau
    std::array<Real, bands> phase;  ///< 4 pi sigma / lambda, so that g = (phase cos)^2
};

/// The two sums over orders for one direction of use, both over 4 cos_i cos_r: the BRDF of E1 for F = 1, and the
/// density of r (times cos_r).
template <class Real>
struct OrderSums {
    Real value, density;
};

/// h_i, h_r = cot/m of the two directions, tan2 = tan^2(delta)/m^2 of the half vector, scale = 1/(4 pi m^2 cos^4
/// delta).
template <class Real>
OrderSums<Real> sum_orders(const OrderNodes<Real>& nodes, const Real& g, const Real& h_i, const Real& h_r,
                           const Real& tan2, const Real& scale) {
    OrderSums<Real> sum{Real(0), Real(0)};
    for (std::size_t j = 0; j < order_nodes; ++j) {
        const Real root = nodes.root[j], ratio = root * root;
        const Real seen = nodes.weight[j] * ratio * exp(-tan2 * ratio) * smith_g1(h_i * root);
        sum.density = sum.density + seen;
        sum.value = fma(seen, smith_g1(h_r * root), sum.value);
    }
    const Real diffuse = one_minus_exp(g) * scale;
    return {sum.value * diffuse, sum.density * diffuse};
}

/// The diffuse part of E1R between two directions; the mirror's part is `mirror_share`.
template <class Real, std::size_t bands>
struct PoissonLobe {
    std::array<Real, bands> value;  ///< BRDF for F = 1, 1/sr; reciprocal
    Real pdf_i, pdf_r;              ///< densities of r sampled from i and of i sampled from r, mean of the bands
    Real cos_theta_h;
};

/// i and r are unit vectors away from the surface; all zero where either is not above it.
template <class Real, std::size_t bands>
PoissonLobe<Real, bands> poisson_lobe(const OrderRules& rules, const Vector<Real>& i, const Vector<Real>& r,
                                      const Vector<Real>& normal, const KirchhoffSurface<Real, bands>& surface) {
    const Real cos_i = dot(i, normal), cos_r = dot(r, normal);
    const auto above = cos_i > constant<Real>(1e-6) && cos_r > constant<Real>(1e-6);
    const Real safe_i = select(above, min(cos_i, Real(1)), Real(1)),
               safe_r = select(above, min(cos_r, Real(1)), Real(1));
    const Vector<Real> sum = i + r;
    const Real length2 = max(dot(sum, sum), constant<Real>(1e-30));
    const Real cos_sum = safe_i + safe_r;
    const Real c2 = max(min(cos_sum * cos_sum / length2, Real(1)), constant<Real>(1e-12));
    const Real inv_m2 = 1 / (surface.m * surface.m);
    const Real tan2 = (1 - c2) / c2 * inv_m2;
    const Real scale = inv_m2 * constant<Real>(0.25 / pi) / (c2 * c2);
    const Real h_i = min(cotangent_over_slope(safe_i, surface.m), constant<Real>(1e9));
    const Real h_r = min(cotangent_over_slope(safe_r, surface.m), constant<Real>(1e9));
    const Real inv_i = 1 / safe_i, inv_r = 1 / safe_r;

    PoissonLobe<Real, bands> lobe;
    lobe.pdf_i = Real(0);
    lobe.pdf_r = Real(0);
    for (std::size_t band = 0; band < bands; ++band) {
        const Real phase2 = surface.phase[band] * surface.phase[band];
        const Real g_i = phase2 * (safe_i * safe_i), g_r = phase2 * (safe_r * safe_r);
        const OrderSums<Real> forth = sum_orders(rules.at(g_i), g_i, h_i, h_r, tan2, scale);
        const OrderSums<Real> back = sum_orders(rules.at(g_r), g_r, h_r, h_i, tan2, scale);
        lobe.value[band] = select(above, min(forth.value, back.value) * inv_i * inv_r, Real(0));
        lobe.pdf_i = lobe.pdf_i + select(above, forth.density * inv_i, Real(0));
        lobe.pdf_r = lobe.pdf_r + select(above, back.density * inv_r, Real(0));
    }
    lobe.pdf_i = lobe.pdf_i * constant<Real>(1.0 / bands);
    lobe.pdf_r = lobe.pdf_r * constant<Real>(1.0 / bands);
    lobe.cos_theta_h = constant<Real>(0.5) * sqrt(length2);
    return lobe;
}

/// e^-g of each band: the share of the mirror ray, for F = 1.
template <class Real, std::size_t bands>
std::array<Real, bands> mirror_share(const KirchhoffSurface<Real, bands>& surface, const Real& cos_i) {
    std::array<Real, bands> share;
    for (std::size_t band = 0; band < bands; ++band) {
        const Real phase = surface.phase[band] * cos_i;
        share[band] = exp(-phase * phase);
    }
    return share;
}

/// Which lobe a photon takes: slope 0 stands for the mirror ray, taken with the mean of `mirror_share`.
/// A band is drawn first, then its order, all from one uniform number.
template <class Real, std::size_t bands>
Real sample_slope(const OrderRules& rules, const KirchhoffSurface<Real, bands>& surface, const Real& cos_i,
                  const Real& u) {
    const Real scaled = u * Real(static_cast<int>(bands));
    const Real band = min(floor(scaled), Real(static_cast<int>(bands) - 1));
    Real phase = surface.phase[0];
    for (std::size_t b = 1; b < bands; ++b)
        phase = select(band > constant<Real>(static_cast<double>(b) - 0.5), surface.phase[b], phase);
    const Real g = (phase * cos_i) * (phase * cos_i);
    const Real mirror = exp(-g), rest = scaled - band - mirror;
    const OrderNodes<Real> nodes = rules.at(g);
    Real root = nodes.root[0], below = nodes.weight[0];
    const Real diffuse = one_minus_exp(g);
    for (std::size_t j = 1; j < order_nodes; ++j) {
        root = select(rest > below * diffuse, nodes.root[j], root);
        below = below + nodes.weight[j];
    }
    return select(rest < 0, Real(0), surface.m / max(root, constant<Real>(1e-10)));
}

}  // namespace brewster
