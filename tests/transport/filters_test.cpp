#include <gtest/gtest.h>

#include <cmath>

#include "bench.h"
#include "scene/gltf_builder.h"

namespace brewster {
namespace {

constexpr KernelChoice full{4, 3, false};

struct Sheet {
    const char* kind;  ///< of BREWSTER_surface
    nlohmann::json filter;
};

// A floor of 1 m2 under sheets of its size, the sun straight above: every photon passes all of them, so that what comes
// through is exact but for the roulette.
std::string floor_under(const std::vector<Sheet>& sheets) {
    GltfBuilder file;
    const auto square = [](float height) {
        return std::vector<glm::vec3>{
            {-0.5f, height, 0.5f}, {0.5f, height, 0.5f}, {0.5f, height, -0.5f}, {-0.5f, height, -0.5f}};
    };
    file.add_polygon("floor", square(0), file.add_material("floor", {0.5, 0.5, 0.5}));
    float height = 0;
    for (auto sheet = sheets.rbegin(); sheet != sheets.rend(); ++sheet) {  // the first is met first
        const int material = file.add_material("sheet", {1, 1, 1});
        file.json["materials"].back()["extensions"]["BREWSTER_surface"] = {{sheet->kind, sheet->filter}};
        file.json["materials"].back()["name"] = "sheet " + std::to_string(material);
        file.add_polygon("sheet " + std::to_string(material), square(height += 0.1f), material);
    }
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}, {"intensity", 1}}};
    file.add_node({{"name", "sun"},
                   {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
                   {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return file.text();
}

struct Passed {
    std::array<double, band_count> polarized{}, unpolarized{};
};

// Shares of the sun's light that enter the floor, for an irradiance of 1 lux.
Passed passed(const std::vector<Sheet>& sheets, std::uint64_t photons) {
    const Scene scene = read_scene_text(floor_under(sheets), "test");
    Bench bench(scene, 1, full);
    bench.trace(0, photons);
    EXPECT_TRUE(bench.sums.ledger.balances());
    EXPECT_EQ(bench.sums.counts.trouble, 0u);
    Passed shares;
    const std::uint32_t floor = scene.charts_of("floor")[0];
    const Quanta* row = bench.sums.entry.estimate(bench.bins.entry.node(floor).leaf());
    for (std::size_t band = 0; band < band_count; ++band) {
        const auto share = [&](int world) {
            const auto channel = static_cast<std::size_t>(bench.bins.entry_fields.field(1, world)) * band_count + band;
            return to_weight(row[channel * RecordLayout<2>::estimate_stride]) * bench.emission.mean_power() /
                   static_cast<double>(photons);
        };
        shares.polarized[band] = share(0);
        shares.unpolarized[band] = share(1);
    }
    return shares;
}

Sheet polarizer_at(double degrees) {
    return {"polarizer", {{"angle", degrees}}};
}

// Malus: 1/2 cos^2; without polarization each polarizer passes half. No weight falls under a quarter, so there is no
// roulette: equal to rounding (and to the photons that fall upon the sheets' common edge).
TEST(Filters, Malus) {
    for (const double degrees : {0.0, 17.0, 30.0, -40.0}) {
        const Passed shares = passed({polarizer_at(10), polarizer_at(10 + degrees)}, 2000);
        const double cosine = std::cos(degrees * pi / 180);
        for (std::size_t band = 0; band < band_count; ++band) {
            EXPECT_NEAR(shares.polarized[band], 0.5 * cosine * cosine, 1e-5) << degrees;
            EXPECT_NEAR(shares.unpolarized[band], 0.25, 1e-5) << degrees;
        }
    }
}

// 1/2 cos^2 t sin^2 t between crossed polarizers (theory 6). The roulette takes weights below 1/4 with the larger of
// both worlds, 1/8 at most: of n photons the share has a standard error below sqrt(share / (4 n)); bound 4 of them.
TEST(Filters, AThirdBetweenCrossedPolarizers) {
    constexpr std::uint64_t photons = 40000;
    const Passed crossed = passed({polarizer_at(0), polarizer_at(90)}, 2000);
    const Passed three = passed({polarizer_at(0), polarizer_at(30), polarizer_at(90)}, photons);
    for (std::size_t band = 0; band < band_count; ++band) {
        EXPECT_LT(crossed.polarized[band], 1e-7);  // floats: half a unit in the last place of the weight
        const double expected = 0.5 * 0.75 * 0.25;
        EXPECT_NEAR(three.polarized[band], expected, 4 * std::sqrt(expected / (4 * static_cast<double>(photons))));
    }
}

// A waveplate at b between crossed polarizers: 1/2 sin^2 2b sin^2(G/2), G = 2 pi dn d / lambda per band (theory 1.3).
TEST(Filters, WaveplateColoursBetweenCrossedPolarizers) {
    constexpr std::uint64_t photons = 40000;
    const double b = 35 * pi / 180;
    const Passed shares = passed({polarizer_at(0),
                                  {"retarder", {{"angle", 35}, {"thickness", 60}, {"birefringence", 0.0091}}},
                                  polarizer_at(90)},
                                 photons);
    for (std::size_t band = 0; band < band_count; ++band) {
        const double half = pi * 0.0091 * 60e3 / band_wavelength_nm[band];
        const double expected = 0.5 * std::pow(std::sin(2 * b) * std::sin(half), 2);
        EXPECT_NEAR(shares.polarized[band], expected, 4 * std::sqrt(expected / (4 * static_cast<double>(photons))));
        EXPECT_NEAR(shares.unpolarized[band], 0.25, 0.01);
    }
    EXPECT_GT(std::abs(shares.polarized[0] - shares.polarized[2]), 0.05);  // the colours differ
}

}  // namespace
}  // namespace brewster
