#include "bins/publish.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "bins/lookup.h"
#include "filing.h"
#include "shapes.h"

namespace brewster {
namespace {

/// Light on one chart: photons thrown evenly on the rectangle, those off the surface dropped, weighted by a density.
class Thrower {
  public:
    using Density = std::function<float(double u, double v)>;

    Thrower(const Outline& outline, const BinSettings& settings, unsigned seed)
        : settings_(settings), tree_({outline}, {}, settings), outline_(outline), random_(seed) {}

    void throw_photons(std::uint64_t count, const Density& density) {
        tally_.resize(tree_.leaf_count());
        std::uniform_real_distribution<double> uniform(0, 1);
        for (std::uint64_t i = 0; i < count; ++i) {
            const double u = uniform(random_), v = uniform(random_);
            if (!inside(u, v)) continue;
            const BinTree<2>::Point point = {lookup::fixed_point_of(static_cast<float>(u)),
                                             lookup::fixed_point_of(static_cast<float>(v))};
            file_light<2>(tree_, tally_, tree_.locate(0, point), point, glm::vec3(density(u, v)), true,
                          static_cast<std::uint32_t>((photons_ + i) % replica_count));
        }
        photons_ += count;
        tree_.absorb(tally_);
        tree_.split_leaves(photons_, settings_);
    }

    // The density is published as itself: one unit of weight a photon on a rectangle of this area.
    Snapshot snapshot() const {
        return publish(tree_, {}, nullptr, photons_, glm::dvec3(outline_.size.x * outline_.size.y), settings_);
    }
    const BinTree<2>& tree() const { return tree_; }
    bool inside(double u, double v) const {
        for (const auto& t : outline_.triangles) {
            const auto side = [&](int i) {
                const glm::dvec2 a = t[static_cast<std::size_t>(i)], b = t[static_cast<std::size_t>((i + 1) % 3)];
                return (b.x - a.x) * (v - a.y) - (b.y - a.y) * (u - a.x);
            };
            const double s0 = side(0), s1 = side(1), s2 = side(2);
            if ((s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0)) return true;
        }
        return false;
    }

  private:
    BinSettings settings_;
    BinTree<2> tree_;
    Outline outline_;
    std::mt19937_64 random_;
    Tally<2> tally_;
    std::uint64_t photons_ = 0;
};

float value_at(const Snapshot& snapshot, double u, double v) {
    return lookup::look_up(snapshot, snapshot.charts[0].direct_root, 0u, lookup::fixed_point_of(static_cast<float>(u)),
                           lookup::fixed_point_of(static_cast<float>(v)))
        .value.y;
}

double relative_rmse(const Snapshot& snapshot, const Thrower& thrower, const Thrower::Density& truth) {
    double sum = 0;
    int count = 0;
    constexpr int n = 200;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double u = (i + 0.5) / n, v = (j + 0.5) / n;
            if (!thrower.inside(u, v)) continue;
            const double t = truth(u, v), error = (value_at(snapshot, u, v) - t) / t;
            sum += error * error;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

/// 1000 photons' worth of a density that is even on each of the tree's cells: exact moments instead of photons.
void file_exactly(BinTree<2>& tree, const Thrower::Density& density) {
    Tally<2> tally;
    tally.resize(tree.leaf_count());
    const double whole = tree.cell(0).geometry.area;
    for (std::uint32_t node = 0; node < tree.node_count(); ++node) {
        if (!tree.node(node).is_leaf()) continue;
        const CellGeometry& g = tree.cell(node).geometry;
        const auto& box = tree.cell(node).box;
        const auto middle = [&](std::size_t a) { return 0.5 * (box.low[a] + box.high[a]) / BREWSTER_UV_ONE; };
        const double weight = 1000 * g.area / whole * static_cast<double>(density(middle(0), middle(1)));
        Quanta* row = tally.touch(tree.node(node).leaf()).estimate;
        for (int band = 0; band < band_count; ++band, row += RecordLayout<2>::estimate_stride) {
            row[0] = to_quanta(weight);
            row[1] = to_quanta(weight * g.mean[0]);
            row[2] = to_quanta(weight * g.mean[1]);
            row[3] = to_quanta(weight);
        }
    }
    tree.absorb(tally);
}

// A constant radiance must come back as one leaf, the same number everywhere.
TEST(Publish, ConstantRadianceIsOneExactLeafOnAnyShape) {
    for (const Outline& outline :
         {shapes::right_triangle(), shapes::l_shape(), shapes::annulus(), shapes::wall_with_window()}) {
        BinTree<2> tree({outline}, {}, BinSettings{});
        file_exactly(tree, [](double, double) { return 1.0f; });
        const double whole = tree.cell(0).geometry.area;
        const Snapshot snapshot = publish(tree, {}, nullptr, 1000, glm::dvec3(2.5 * whole), BinSettings{});
        EXPECT_EQ(snapshot.charts[0].direct_leaves, 1u);
        EXPECT_EQ(snapshot.charts[0].indirect_leaves, 1u);
        for (const double u : {0.02, 0.31, 0.5, 0.77})
            for (const double v : {0.03, 0.4, 0.98}) EXPECT_NEAR(value_at(snapshot, u, v), 2.5, 2.5e-6);
    }
}

// A step of +- e across half of a square explains e^2 n / 12 times its noise beyond a linear fit, of n = 500 photons
// there: 1.84 and .42. Alone neither is above 2 * 1.7 times the noise, as a split across the whole square is not (2.8).
TEST(Publish, FaintStepsAreTrustedBesideStrongOnes) {
    const auto leaves = [](float step, float other_half) {
        BinTree<2> tree({shapes::rectangle(1, 1)}, {}, BinSettings{});
        file_exactly(tree, [&](double u, double v) { return u > 0.5 ? other_half : v < 0.5 ? 1 + step : 1 - step; });
        return publish(tree, {}, nullptr, 1000, glm::dvec3(1), BinSettings{}).charts[0].direct_leaves;
    };
    EXPECT_EQ(leaves(0.21f, 1), 1u);
    EXPECT_EQ(leaves(0.21f, 4), 3u);
    EXPECT_EQ(leaves(0.1f, 4), 2u);
}

// Photons get lost on the way with probability 1/2, so the flux of n photons has variance n / 4 and not sum w^2 = n /
// 2: the replicas must see that.
TEST(Publish, EvenPhotonsAreOneLeafWithAnHonestError) {
    std::mt19937 coin(1);
    const auto lossy = [&](double, double) { return (coin() & 1024u) != 0 ? 1.0f : 0.0f; };
    constexpr int runs = 200;
    double squares = 0, reported = 0;
    unsigned leaves = 0;
    for (unsigned seed = 0; seed < runs; ++seed) {
        Thrower thrower(shapes::rectangle(1, 1), BinSettings{}, seed);
        for (int batch = 0; batch < 4; ++batch) thrower.throw_photons(2000, lossy);
        const Snapshot snapshot = thrower.snapshot();
        leaves += snapshot.charts[0].direct_leaves;
        const auto middle =
            lookup::look_up(snapshot, snapshot.charts[0].direct_root, 0u, BREWSTER_UV_ONE / 2, BREWSTER_UV_ONE / 2);
        squares += std::pow(middle.value.x - 0.5, 2);
        reported += middle.standard_error.x * middle.standard_error.x;
    }
    // A false split at the root needs a chi-square of 3 degrees above 12 (0.7 %), and eleven levels stand below.
    EXPECT_LE(leaves, runs + runs / 8);
    // Reported is the rms error of a linear cell, 3 times the variance of its mean, that is of its middle. The mean of
    // 200 squared normals has a relative standard deviation of 0.1; sum w^2 alone would give a half.
    EXPECT_NEAR(3 * squares / reported, 1, 0.35);
}

TEST(Publish, MorePhotonsLowerTheErrorOfASmoothField) {
    const auto smooth = [](double u, double v) {
        return static_cast<float>(1 + 0.9 * std::sin(5 * u) * std::cos(4 * v));
    };
    double previous = 1;
    for (const int batches : {8, 14, 20}) {
        Thrower thrower(shapes::rectangle(1, 1), BinSettings{}, 5);
        std::uint64_t count = 2000;
        for (int batch = 0; batch < batches; ++batch, count += count / 4) thrower.throw_photons(count, smooth);
        const double error = relative_rmse(thrower.snapshot(), thrower, smooth);
        EXPECT_LT(error, 0.75 * previous);
        previous = error;
    }
    EXPECT_LT(previous, 0.06);
}

// A step that no border of cells can follow: what cells hide is most of the error, and is told by what sharing corners
// changes. Of cells by themselves the splits below tell less of it, the less the more photons there are.
TEST(Publish, BarsHoldWhatASlantedEdgeHides) {
    const auto slanted = [](double u, double v) { return u + 0.7 * v < 0.9 ? 1.0f : 0.2f; };
    const auto true_over_said = [&](int batches, bool join_corners) {
        BinSettings settings;
        settings.join_corners = join_corners;
        double errors = 0, said = 0;
        for (unsigned seed = 0; seed < 8; ++seed) {
            Thrower thrower(shapes::rectangle(1, 1), settings, seed);
            std::uint64_t count = 2000;
            for (int batch = 0; batch < batches; ++batch, count += count / 4) thrower.throw_photons(count, slanted);
            const Snapshot snapshot = thrower.snapshot();
            for (int place = 0; place < 10000; ++place) {
                const double u = (place % 100 + 0.5) / 100, v = (place / 100 + 0.5) / 100;
                const auto found = lookup::look_up(snapshot, snapshot.charts[0].direct_root, 0u,
                                                   lookup::fixed_point_of(static_cast<float>(u)),
                                                   lookup::fixed_point_of(static_cast<float>(v)));
                errors += std::pow(static_cast<double>(found.value.y - slanted(u, v)), 2);
                said += std::pow(static_cast<double>(found.standard_error.y), 2);
            }
        }
        return std::sqrt(errors / said);
    };
    for (const int batches : {14, 17}) {
        const double joined = true_over_said(batches, true), alone = true_over_said(batches, false);
        std::printf("%d batches: true over said %.2f, without shared corners %.2f\n", batches, joined, alone);
        EXPECT_NEAR(joined, 1, 0.25);
        EXPECT_GT(alone, 1.35);
    }
}

TEST(Publish, StepsStaySharpAndSmoothBordersJoin) {
    const auto step = [](double u, double) { return u < 0.5 ? 4.0f : 1.0f; };
    Thrower thrower(shapes::rectangle(1, 1), BinSettings{}, 9);
    std::uint64_t count = 4000;
    for (int batch = 0; batch < 14; ++batch, count += count / 4) thrower.throw_photons(count, step);
    const Snapshot snapshot = thrower.snapshot();
    for (const double v : {0.11, 0.37, 0.63, 0.91}) {
        EXPECT_NEAR(value_at(snapshot, 0.499, v), 4, 0.4);
        EXPECT_NEAR(value_at(snapshot, 0.501, v), 1, 0.3);
    }
    const auto smooth = [](double u, double v) {
        return static_cast<float>(1 + 0.9 * std::sin(5 * u) * std::cos(4 * v));
    };
    Thrower smooth_thrower(shapes::rectangle(1, 1), BinSettings{}, 9);
    count = 4000;
    for (int batch = 0; batch < 16; ++batch, count += count / 4) smooth_thrower.throw_photons(count, smooth);
    const Snapshot joined = smooth_thrower.snapshot();
    ASSERT_GT(joined.charts[0].direct_leaves, 8u);
    int steps = 0, pairs = 0;
    for (int i = 0; i < 4000; ++i) {  // along both diagonals' neighbours, in steps far smaller than a cell
        const double v = 0.013 + 0.97 * ((i * 7) % 4000) / 4000.0, u = i / 4000.0;
        const double a = value_at(joined, u, v), b = value_at(joined, u + 1e-6, v);
        steps += std::abs(a - b) > 0.01 * a;
        ++pairs;
    }
    EXPECT_LE(steps, pairs / 100);
}

TEST(Publish, WithoutSharedCornersBordersStep) {
    BinSettings settings;
    settings.join_corners = false;
    const auto smooth = [](double u, double v) {
        return static_cast<float>(1 + 0.9 * std::sin(5 * u) * std::cos(4 * v));
    };
    Thrower thrower(shapes::rectangle(1, 1), settings, 9);
    std::uint64_t count = 4000;
    for (int batch = 0; batch < 16; ++batch, count += count / 4) thrower.throw_photons(count, smooth);
    const Snapshot snapshot = thrower.snapshot();
    double largest = 0;
    for (int i = 1; i < 4096; ++i) {
        const double u = i / 4096.0;
        largest = std::max(largest, std::abs(static_cast<double>(value_at(snapshot, u - 1e-6, 0.3) -
                                                                 value_at(snapshot, u + 1e-6, 0.3))));
    }
    EXPECT_GT(largest, 0.01);
}

// The mean over the chart is what was thrown, whatever leaves were chosen.
TEST(Publish, KeepsTheFlux) {
    const auto step = [](double u, double v) { return u + v < 0.8 ? 3.0f : 0.5f; };
    Thrower thrower(shapes::rectangle(2, 1), BinSettings{}, 11);
    std::uint64_t count = 4000;
    for (int batch = 0; batch < 12; ++batch, count += count / 4) thrower.throw_photons(count, step);
    const Snapshot snapshot = thrower.snapshot();
    double mean = 0;
    constexpr int n = 512;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) mean += value_at(snapshot, (i + 0.5) / n, (j + 0.5) / n) / (n * n);
    Wide total = 0;
    for (std::uint32_t node = 0; node < thrower.tree().node_count(); ++node)
        total += thrower.tree().sums(node).estimate[0];
    EXPECT_NEAR(mean, to_weight(total) / static_cast<double>(snapshot.photons), 0.004 * mean);
}

// Light that the polarized world sees as a ramp and the unpolarized one as its mirror image, three times as bright:
// both stand behind each other in the same leaves.
TEST(Publish, WorldsStandBehindEachOtherInTheSameLeaves) {
    const EntryFields fields{band_count, 1, 2};
    BinSettings settings;
    BinTree<2> tree({shapes::rectangle(1, 1)}, fields.layout(), settings);
    Tally<2> tally(fields.layout());
    tally.resize(tree.leaf_count());
    std::mt19937 random(5);
    constexpr std::uint32_t photons = 200000;
    for (std::uint32_t i = 0; i < photons; ++i) {
        const BinTree<2>::Point point = {static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE),
                                         static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE)};
        const float u = static_cast<float>(point[0]) / BREWSTER_UV_ONE;
        const std::array<float, 6> indirect = {u, u, u, 3 - 3 * u, 3 - 3 * u, 3 - 3 * u};
        const std::array<float, 3> direct = {0.5f, 0.5f, 0.5f};
        const std::uint32_t leaf = tree.locate(0, point);
        file_event<2>(tree, tally, leaf, point, {fields.field(1, 0), 0, indirect, i % 8});
        file_event<2>(tree, tally, leaf, point, {fields.field(0, 0), 0, direct, i % 8});
    }
    tree.absorb(tally);
    const Snapshot snapshot = publish(tree, fields, nullptr, photons, glm::dvec3(1, 2, 4), settings);
    EXPECT_EQ(snapshot.direct_offset(1), 0u);
    EXPECT_EQ(snapshot.indirect_offset(1), 1u);
    const auto at = [&](float u, int world) {
        return lookup::look_up(snapshot, snapshot.charts[0].indirect_root, snapshot.indirect_offset(world),
                               lookup::fixed_point_of(u), BREWSTER_UV_ONE / 2)
            .value;
    };
    for (const float u : {0.1f, 0.5f, 0.9f}) {
        // A linear fit of n photons of weight w: error at the ends below 2 w / sqrt(n) = 0.5 % of 1; five of them.
        EXPECT_NEAR(at(u, 0).x, u, 0.025f);
        EXPECT_NEAR(at(u, 1).x, 3 - 3 * u, 0.075f);
        EXPECT_NEAR(at(u, 0).z / at(u, 0).x, 4.0f, 1e-4f);  // one colour: flux per weight says which
    }
}

}  // namespace
}  // namespace brewster
