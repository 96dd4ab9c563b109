#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "base/units.h"
#include "bins/lookup.h"
#include "engine/engine.h"
#include "optics/axis_across.h"
#include "optics/frame.h"
#include "scene/gltf_builder.h"
#include "scene/prepared_material.h"
#include "slow.h"
#include "trace.h"

namespace brewster {
namespace {

// A closed room of 2 m whose Lambert walls of albedo 1/2 glow with radiance 1, so that light of radiance 2 comes from
// everywhere, unpolarized; and inside a slab that loses nothing. It must look as if it were not there (theory 6, 3.9).
struct Furnace {
    explicit Furnace(const nlohmann::json& slab) {
        GltfBuilder file;
        file.add_material("wall", {0.5, 0.5, 0.5}, 1);
        const int material = file.add_material("slab", {1, 1, 1});
        for (const auto& [key, value] : slab.items()) file.json["materials"].back()[key] = value;
        file.add_box("room", {-1, -1, -1}, {1, 1, 1}, true);
        file.add_box("slab", {-0.4f, -0.1f, -0.3f}, {0.4f, 0.1f, 0.3f}, false, material);
        scene = std::make_shared<const Scene>(read_scene_text(file.text(), "furnace with a slab"));
    }
    std::shared_ptr<const Snapshot> trace(std::uint64_t photons, std::uint64_t seed) const {
        EngineSettings settings;
        settings.seed = seed;
        settings.kernel = KernelChoice{4, 3, true};
        Engine engine(scene, settings);
        brewster::trace(engine, photons);
        EXPECT_EQ(engine.progress().trouble, 0u);
        return engine.snapshot();
    }
    std::shared_ptr<const Scene> scene;
};

using Stokes4 = std::array<double, 4>;

struct GlossLeaf {
    std::array<double, 2> low{0, 0}, high{1, 1};  ///< on the square of directions
    Stokes4 value{}, error{};
};

void collect(const GlossBins& gloss, std::uint32_t node, GlossLeaf cell, std::vector<GlossLeaf>& leaves) {
    const glm::uvec2 at = gloss.nodes[node];
    if ((at.y & BREWSTER_NODE_LEAF) != 0) {
        const std::size_t first = (at.y & ~BREWSTER_NODE_LEAF) * static_cast<std::size_t>(gloss.fields());
        for (std::size_t j = 0; j < 4; ++j) {
            const glm::vec4 texel = gloss.leaves[(first + j) * BREWSTER_GLOSS_FIELD_TEXELS];
            cell.value[j] = static_cast<double>(texel.x);
            cell.error[j] = static_cast<double>(texel.w);
        }
        leaves.push_back(cell);
        return;
    }
    const std::uint32_t axis = at.y >> BREWSTER_NODE_AXIS_SHIFT, child = at.y & BREWSTER_NODE_INDEX;
    for (const bool low : {true, false}) {
        GlossLeaf part = cell;
        if (axis >= 2) (low ? part.high : part.low)[axis - 2] = static_cast<double>(at.x) / BREWSTER_UV_ONE;
        collect(gloss, child + (low ? 0 : 1), part, leaves);
    }
}

// The concentric map backwards: a point of the square to the direction, about z.
Vector<double> direction_of(double square_x, double square_y) {
    const double a = 2 * square_x - 1, b = 2 * square_y - 1;
    const bool wide = std::abs(a) >= std::abs(b);
    const double r = wide ? a : b;
    const double angle = r == 0 ? 0 : 0.25 * pi * (wide ? b / a : a / b);
    const double x = r * (wide ? std::cos(angle) : std::sin(angle)), y = r * (wide ? std::sin(angle) : std::cos(angle));
    return {x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))};
}

// What the interface alone sends in an isotropic unpolarized field of radiance 2, mean over the cell, in the frame that
// is carried from the chart's u axis: E and E1 in the s frame.
Stokes4 expected(const PreparedMaterial& material, const GlossLeaf& leaf) {
    constexpr int steps = 12;
    const Vector<double> up{0, 0, 1}, tangent{1, 0, 0};
    Stokes4 mean{};
    for (int i = 0; i < steps * steps; ++i) {
        const auto at = [&](std::size_t axis, int step) {
            return leaf.low[axis] + (leaf.high[axis] - leaf.low[axis]) * (step + 0.5) / steps;
        };
        const Vector<double> direction = direction_of(at(0, i % steps), at(1, i / steps));
        const Passage<double> through = material.passage(0, direction.z);
        // The mirror's share of a Kirchhoff surface is left to rays.
        const InterfaceMueller<double> smooth =
            dielectric_interface(direction.z, static_cast<double>(material.n[0])).reflection;
        const double mirror =
            material.finish == Finish::kirchhoff ? mirror_share(material.kirchhoff<double, 1>(), direction.z)[0] : 0;
        const Stokes<double, 4> light{
            {2 * (1 - through.unpolarized - mirror * smooth.a), 2 * (-through.s_minus_p - mirror * smooth.b), 0, 0}};
        const auto turned = rotate(
            rotation_between(direction, axis_across(direction, up), transported_axis(up, tangent, direction)), light);
        for (int j = 0; j < 4; ++j) mean[static_cast<std::size_t>(j)] += turned[j] / (steps * steps);
    }
    return mean;
}

struct Deviations {
    int leaves = 0;
    std::array<int, 4> beyond{};  ///< 2.6 standard errors, per component
    double polarization = 0;      ///< largest |S1 + S1 of the base| / 2 of cells known to 1 %
};

Deviations deviations(const Furnace& furnace, const Snapshot& bins) {
    const PreparedMaterial material = prepare_materials(furnace.scene->materials)[1];
    Deviations found;
    for (const std::uint32_t chart : furnace.scene->charts_of("slab")) {
        if (bins.gloss.roots[chart] == no_root) continue;
        std::vector<GlossLeaf> leaves;
        collect(bins.gloss, bins.gloss.roots[chart], {}, leaves);
        for (const GlossLeaf& leaf : leaves) {
            const Stokes4 right = expected(material, leaf);
            ++found.leaves;
            for (std::size_t j = 0; j < 4; ++j) {
                found.beyond[j] += std::abs(leaf.value[j] - right[j]) > 2.6 * leaf.error[j] + 1e-9;
                if (j > 0 && leaf.error[j] < 0.02)
                    found.polarization = std::max(found.polarization, std::abs(leaf.value[j] - right[j]) / 2);
            }
        }
    }
    return found;
}

const nlohmann::json plastic = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", std::sqrt(0.3)}}},
                                {"extensions", {{"KHR_materials_ior", {{"ior", 1.5}}}}}};
const nlohmann::json waves = {
    {"pbrMetallicRoughness", {{"metallicFactor", 0}}},
    {"extensions",
     {{"KHR_materials_ior", {{"ior", 1.5}}}, {"BREWSTER_surface", {{"rmsHeight", 0.1}, {"correlationLength", 1.5}}}}}};

// A rough slab of models V and E1R with a white base: gloss and base together are unpolarized and of radiance 2. Of the
// cells of V's gloss not more than 1 % (a normal distribution: .93 %) and three binomial standard errors of it lie beyond
// 2.6 of their own, in any polarized component. Of E1R's, whose weights spread more, some cells got a handful of photons
// that tell too little of their spread: 3 %. S3 holds nothing at all.
TEST(PolarizedFurnace, ARoughSlabStaysUnpolarized) {
    for (const auto& [slab, share] : {std::pair{plastic, 0.01}, std::pair{waves, 0.03}}) {
        const Furnace furnace(slab);
        const auto bins = furnace.trace(slow ? 100000 : 1000000, 3);
        const Deviations found = deviations(furnace, *bins);
        std::printf("%d cells, beyond 2.6 standard errors: S0 %d, S1 %d, S2 %d, S3 %d; most polarized by %.2f %%\n",
                    found.leaves, found.beyond[0], found.beyond[1], found.beyond[2], found.beyond[3],
                    100 * found.polarization);
        EXPECT_GT(found.leaves, slow ? 20 : 100);
        const double n = found.leaves, bound = share * n + 3 * std::sqrt(share * n) + 1;
        for (std::size_t j = 1; j < 3; ++j) EXPECT_LE(found.beyond[j], bound) << "S" << j;
        EXPECT_EQ(found.beyond[3], 0);
    }
}

// Light that enters the slab's base is pi times the radiance times what the interface lets in, everywhere, in both
// worlds; and the walls, which see each other and the slab, do not notice that it is there.
TEST(PolarizedFurnace, NothingIsLostInEitherWorld) {
    const Furnace furnace(plastic);
    const auto bins = furnace.trace(slow ? 100000 : 400000, 4);
    const Scene& scene = *furnace.scene;
    const PreparedMaterial material = prepare_materials(scene.materials)[1];
    double passed = 0;  // 2 integral of (1 - E) c dc
    for (int i = 0; i < 1000; ++i) {
        const double c = (i + 0.5) / 1000;
        passed += 2 * c * material.passage(0, c).unpolarized / 1000;
    }
    const double slack = slow ? 0.06 : 0.03;  // 4 standard errors of a chart that gets 1 photon in 40: .02
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart) {
        const bool wall = scene.charts[chart].mesh == "room";
        const ChartBins& at = bins->charts[chart];
        for (const int world : {0, 1}) {
            double mean = 0;
            for (std::uint32_t i = 0; i < 16; ++i) {
                const std::uint32_t u = (2 * (i % 4) + 1) * (BREWSTER_UV_ONE / 8);
                const std::uint32_t v = (2 * (i / 4) + 1) * (BREWSTER_UV_ONE / 8);
                const auto direct = lookup::look_up(*bins, at.direct_root, bins->direct_offset(world), u, v);
                const auto indirect = lookup::look_up(*bins, at.indirect_root, bins->indirect_offset(world), u, v);
                mean += static_cast<double>(direct.value.x + indirect.value.x) / 16;
            }
            EXPECT_NEAR(mean / (2 * pi * (wall ? 1 : passed)), 1, slack) << scene.charts[chart].mesh << " " << world;
        }
    }
}

}  // namespace
}  // namespace brewster
