#include "optics/rough_interface.h"

#include <algorithm>
#include <cmath>

namespace brewster {
namespace {

/// Gauss-Legendre on [-1, 1], 12 nodes, one of each pair (Abramowitz and Stegun 25.4.30).
constexpr double gauss_nodes[6] = {0.125233408511468916, 0.367831498998180194, 0.587317954286617447,
                                   0.769902674194304687, 0.904117256370474857, 0.981560634246719251};
constexpr double gauss_weights[6] = {0.249147045813402785, 0.233492536538354809, 0.203167426723065922,
                                     0.160078328543346226, 0.106939325995318431, 0.047175336386511827};

/// Calls function(x, weight) for composite Gauss-Legendre on [low, high].
template <class Function>
void integrate(double low, double high, int panels, Function function) {
    const double half = 0.5 * (high - low) / panels;
    for (int panel = 0; panel < panels; ++panel) {
        const double middle = low + half * (2 * panel + 1);
        for (int j = 0; j < 6; ++j) {
            function(middle - half * gauss_nodes[j], half * gauss_weights[j]);
            function(middle + half * gauss_nodes[j], half * gauss_weights[j]);
        }
    }
}

constexpr double slope_reach = 5.5;  // exp(-5.5^2) = 7e-14

/// Calls function(facet, r, mass) for the facets of slope m that a ray at cos_theta in the half plane y = 0, x > 0
/// meets and reflects above the horizon: mass is the visible normals' density times the weight, and counts the mirror
/// image at -y as well.
template <class Function>
void integrate_visible_facets(double cos_theta, double m, int panels, Function function) {
    const double h = cotangent_over_slope(cos_theta, m), g1 = smith_g1(h);
    const double sine = std::sqrt((1 - cos_theta) * (1 + cos_theta));
    const Vector<double> i{sine, 0, cos_theta};
    // y = Y sin t: where Y is the last slope across that still reflects above the horizon, the edge stays smooth.
    const double edge = std::min(slope_reach, 1 / (m * cos_theta));
    integrate(0, 0.5 * pi, panels, [&](double t, double wt) {
        const double y = edge * std::sin(t), wy = wt * edge * std::cos(t);
        // r is above the horizon between the roots of cos m^2 x^2 - 2 sin m x - cos (1 - m^2 y^2) = 0.
        const double level = cos_theta * (1 - m * m * y * y), root2 = sine * sine + cos_theta * level;
        if (root2 <= 0) return;
        const double upper = sine + std::sqrt(root2);
        const double low = std::max(-level / (m * upper), -std::min(h, slope_reach));
        const double high = std::min(upper / (cos_theta * m), slope_reach);
        if (low >= high) return;
        integrate(low, high, 2 * panels, [&](double x, double wx) {
            const Vector<double> facet = normalized(Vector<double>{m * x, m * y, 1});
            const Vector<double> r = reflected(-i, facet);
            if (r.z <= 0) return;
            // Visible facets: (1 + x/h) exp(-x^2 - y^2) G1/pi dx dy; y < 0 is the mirror image.
            function(facet, r, 2 * wx * wy * std::exp(-x * x - y * y) * (1 / pi) * (1 + x / h) * g1);
        });
    });
}

}  // namespace

DirectionalAlbedo directional_albedo(double cos_theta, double n, double k, double m, int panels) {
    const Vector<double> i{std::sqrt((1 - cos_theta) * (1 + cos_theta)), 0, cos_theta}, s{0, 1, 0};
    DirectionalAlbedo sum{0, 0};
    integrate_visible_facets(
        cos_theta, m, panels, [&](const Vector<double>& facet, const Vector<double>& r, double mass) {
            const auto plane = plane_of_incidence(-i, s, facet);
            const double passed = mass * smith_g1(cotangent_over_slope(r.z, m));
            const InterfaceMueller<double> event =
                k > 0 ? mueller_reflection(plane.cos_theta_i, n, k) : mueller_reflection(plane.cos_theta_i, n);
            sum.unpolarized += passed * event.a;
            sum.s_minus_p += passed * event.b * plane.turn.cos_2t;
        });
    return sum;
}

DirectionalAlbedo directional_albedo(double cos_theta, double n, const OrderRules& rules,
                                     const KirchhoffSurface<double, 1>& surface, int panels) {
    const Vector<double> i{std::sqrt((1 - cos_theta) * (1 + cos_theta)), 0, cos_theta}, s{0, 1, 0}, up{0, 0, 1};
    const double share = mirror_share(surface, cos_theta)[0], phase = surface.phase[0] * cos_theta;
    const InterfaceMueller<double> mirror = mueller_reflection(cos_theta, n);
    DirectionalAlbedo sum{share * mirror.a, share * mirror.b};
    const OrderNodes<double> nodes = rules.at(phase * phase);
    for (std::size_t j = 0; j < order_nodes; ++j) {
        const double drawn = (1 - share) * nodes.weight[j];
        if (drawn < 1e-9) continue;
        integrate_visible_facets(cos_theta, surface.m / nodes.root[j], panels,
                                 [&](const Vector<double>& facet, const Vector<double>& r, double mass) {
                                     const PoissonLobe<double, 1> lobe = poisson_lobe(rules, i, r, up, surface);
                                     if (lobe.pdf_i <= 0) return;
                                     const auto plane = plane_of_incidence(-i, s, facet);
                                     const double passed = drawn * mass * lobe.value[0] * r.z / lobe.pdf_i;
                                     const InterfaceMueller<double> event = mueller_reflection(plane.cos_theta_i, n);
                                     sum.unpolarized += passed * event.a;
                                     sum.s_minus_p += passed * event.b * plane.turn.cos_2t;
                                 });
    }
    return sum;
}

RoughInterface::RoughInterface(double n, double m)
    : RoughInterface(n, [&](double cos_theta) { return directional_albedo(cos_theta, n, 0, m, 2); }) {}

RoughInterface::RoughInterface(double n, const OrderRules& rules, const KirchhoffSurface<double, 1>& surface)
    : RoughInterface(n, [&](double cos_theta) { return directional_albedo(cos_theta, n, rules, surface, 1); }) {}

RoughInterface::RoughInterface(double n, const std::function<DirectionalAlbedo(double)>& albedo_at) : n_(n) {
    for (int row = 0; row < rows; ++row) {
        const double x = static_cast<double>(row) / (rows - 1);
        // At grazing incidence G1 = 0 and 1 + x/h grows without bound; their product has the limit taken at 1e-6.
        const DirectionalAlbedo albedo = albedo_at(std::max(x * x, 1e-6));
        table_[static_cast<std::size_t>(row)] = {static_cast<float>(1 - albedo.unpolarized),
                                                 static_cast<float>(-albedo.s_minus_p)};
    }
    // Exact for the table: 1 - E is cubic in x = sqrt(cos) within a row, and 2 cos dcos = 4 x^3 dx.
    double passed = 0;
    for (int row = 0; row + 1 < rows; ++row)
        integrate(static_cast<double>(row) / (rows - 1), static_cast<double>(row + 1) / (rows - 1), 1,
                  [&](double x, double weight) { passed += weight * 4 * x * x * x * passage(x * x).unpolarized; });
    external_ = 1 - passed;
}

}  // namespace brewster
