#include "optics/poisson_lobes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace brewster {
namespace {

using NodesAndWeights = std::array<std::array<double, 2>, order_nodes>;

/// Eigenvalues of a symmetric matrix with the first components of the eigenvectors, by Jacobi rotations.
NodesAndWeights eigenvalues(std::array<std::array<double, order_nodes>, order_nodes> a) {
    std::array<std::array<double, order_nodes>, order_nodes> v{};
    for (std::size_t j = 0; j < order_nodes; ++j) v[j][j] = 1;
    for (int sweep = 0; sweep < 60; ++sweep)
        for (std::size_t p = 0; p < order_nodes; ++p)
            for (std::size_t q = p + 1; q < order_nodes; ++q) {
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
                const double c = 1 / std::hypot(t, 1.0), s = t * c;
                for (std::size_t k = 0; k < order_nodes; ++k) {
                    const double kp = a[k][p], kq = a[k][q];
                    a[k][p] = c * kp - s * kq;
                    a[k][q] = s * kp + c * kq;
                }
                for (std::size_t k = 0; k < order_nodes; ++k) {
                    const double pk = a[p][k], qk = a[q][k];
                    a[p][k] = c * pk - s * qk;
                    a[q][k] = s * pk + c * qk;
                    const double vp = v[k][p], vq = v[k][q];
                    v[k][p] = c * vp - s * vq;
                    v[k][q] = s * vp + c * vq;
                }
                a[p][q] = a[q][p] = 0;
            }
    NodesAndWeights result;
    for (std::size_t j = 0; j < order_nodes; ++j) result[j] = {a[j][j], v[0][j] * v[0][j]};
    return result;
}

/// Gauss rule of the Poisson law given n >= 1, in x = 1/n: Lanczos on the law itself, then Golub and Welsch 1969.
NodesAndWeights gauss_rule(double g) {
    const int first = std::max(1, static_cast<int>(g - 12 * std::sqrt(g) - 5));
    const int last = static_cast<int>(g + 14 * std::sqrt(g) + 40);
    std::vector<double> x, q;
    for (int n = first; n <= last; ++n) {
        x.push_back(1.0 / n);
        q.push_back(0.5 * (n * std::log(g) - std::lgamma(n + 1.0)));
    }
    const double largest = *std::max_element(q.begin(), q.end());
    for (double& value : q) value = std::exp(value - largest);
    const auto normalize = [](std::vector<double>& vector) {
        const double norm = std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
        for (double& value : vector) value /= norm;
        return norm;
    };
    normalize(q);
    std::array<std::array<double, order_nodes>, order_nodes> jacobi{};
    std::vector<std::vector<double>> basis = {q};
    for (std::size_t j = 0; j < order_nodes; ++j) {
        std::vector<double> next(x.size());
        for (std::size_t k = 0; k < x.size(); ++k) next[k] = x[k] * basis[j][k];
        jacobi[j][j] = std::inner_product(next.begin(), next.end(), basis[j].begin(), 0.0);
        for (int repeat = 0; repeat < 2; ++repeat)
            for (const auto& earlier : basis) {
                const double along = std::inner_product(next.begin(), next.end(), earlier.begin(), 0.0);
                for (std::size_t k = 0; k < x.size(); ++k) next[k] -= along * earlier[k];
            }
        if (j + 1 == order_nodes) break;
        const double norm = normalize(next);
        // A law on fewer points than nodes ends here: the nodes left over sit at 1/(j + 2) with no weight.
        if (norm < 1e-12) {
            for (std::size_t k = j + 1; k < order_nodes; ++k) jacobi[k][k] = 1.0 / static_cast<double>(k + 1);
            break;
        }
        jacobi[j][j + 1] = jacobi[j + 1][j] = norm;
        basis.push_back(next);
    }
    NodesAndWeights rule = eigenvalues(jacobi);
    std::sort(rule.begin(), rule.end(), [](const auto& a, const auto& b) { return a[0] > b[0]; });
    return rule;
}

}  // namespace

OrderRules::OrderRules() {
    for (int row = 0; row < rows; ++row) {
        const double share = row / rows_per_unit;
        const double root = knee * share / (1 - share), g = std::max(root * root, 1e-8);
        const NodesAndWeights rule = gauss_rule(g);
        double sum = 0;
        for (std::size_t j = 0; j < order_nodes; ++j) sum += rule[j][1];
        for (std::size_t j = 0; j < order_nodes; ++j) {
            table_[static_cast<std::size_t>(row)][j] = static_cast<float>(std::sqrt((1 + g) * rule[j][0]));
            table_[static_cast<std::size_t>(row)][order_nodes + j] = static_cast<float>(rule[j][1] / sum);
        }
    }
}

}  // namespace brewster
