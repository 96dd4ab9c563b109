// Lamps, holes and rooms of every size, anywhere.
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "engine/slow.h"
#include "hard/hard.h"

namespace brewster {
namespace {

constexpr std::uint64_t photons_a_size = slow ? 4000 : 40000;

// A lamp of a micrometre a metre above the middle of a tile of two centimetres: L A / r^2.
TEST(Sizes, LampOfAMicrometre) {
    SceneFile file;
    file.quad("tile", {-0.01f, 0, 0.01f}, {0.02f, 0, 0}, {0, 0, -0.02f}, file.material(0));
    file.quad("ground", {-9, -0.01f, 9}, {18, 0, 0}, {0, 0, -18}, file.material(0));
    file.quad("lamp", {-0.5e-6f, 1, -0.5e-6f}, {1e-6f, 0, 0}, {0, 0, 1e-6f}, file.material(0, 1e12));
    // The ground gets cos^4 integrated over a square of 18 m: nearly all of pi.
    double form = 0;
    constexpr int side = 2000;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double x = 18.0 * (i + 0.5) / side - 9, z = 18.0 * (j + 0.5) / side - 9;
            form += 1.01 * 1.01 / std::pow(x * x + z * z + 1.01 * 1.01, 2) * std::pow(18.0 / side, 2);
        }
    const Solved result = solved(file, photons_a_size);
    expect_value(result.on("ground"), form / (18 * 18), "below a lamp of a micrometre");
    expect_value(solved(file, 20 * photons_a_size).on("tile"), 1, "right below it");
}

// A lamp of ten kilometres a metre above a tile: pi L.
TEST(Sizes, LampOfTenKilometres) {
    SceneFile file;
    file.quad("tile", {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, file.material(0));
    file.quad("lamp", {-5000, 1, -5000}, {10000, 0, 0}, {0, 0, 10000}, file.material(0, 2));
    expect_value(solved(file, photons_a_size).on("tile"), 2 * pi, "below a lamp of ten kilometres");
}

// A sun through a hole of a millionth of the wall: what comes through is lux times the hole. Few photons do.
TEST(Sizes, SunThroughAKeyhole) {
    SceneFile file;
    const int black = file.material(0);
    constexpr float hole = 1e-3f, middle = 0.5f, low = middle - hole / 2, high = middle + hole / 2;
    file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, black);
    // The ceiling around the hole, its front inwards.
    file.quad("left", {0, 1, 0}, {low, 0, 0}, {0, 0, 1}, black);
    file.quad("right", {high, 1, 0}, {low, 0, 0}, {0, 0, 1}, black);
    file.quad("near", {low, 1, 0}, {hole, 0, 0}, {0, 0, low}, black);
    file.quad("far", {low, 1, high}, {hole, 0, 0}, {0, 0, low}, black);
    file.sun(1e6, {0, -1, 0});
    const Measured found = solved(file, slow ? 200000 : 2000000).on("floor");
    std::printf("through the keyhole: %.3g +- %.2g lm, expected 1\n", found.mean, found.error);
    EXPECT_NEAR(found.mean, 1, slow ? 5 : 4 * found.error);
    EXPECT_LT(found.error, slow ? 5 : 0.5);
}

// The same room of a millimetre and of 100 km, and a room of a metre 1000 km from the origin: as bright, and tight.
TEST(Sizes, RoomsOfEverySizeAnywhere) {
    const auto room = [](double size, double x) {
        SceneFile file;
        file.box("room", glm::vec3(0), glm::vec3(1), true, file.material(0.5));
        file.quad("lamp", {0.25f, 0.99f, 0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f}, file.material(0, 10));
        const std::string change = R"({"scale": [)" + digits(size) + "," + digits(size) + "," + digits(size) +
                                   R"(], "translation": [)" + digits(x) + ",0,0]}";
        file.node_changes("room", change);
        file.node_changes("lamp", change);
        return solved(file, photons_a_size / 2, {}, 4);
    };
    const Solved usual = room(1, 0);
    for (const auto& [size, x] : {std::pair(1e-3, 0.0), {1e5, 0.0}, {1.0, 1e6}}) {
        const Solved other = room(size, x);
        EXPECT_EQ(other.escaped, 0) << size << ' ' << x;
        EXPECT_NEAR(other.everywhere.mean, usual.everywhere.mean,
                    4 * (other.everywhere.error + usual.everywhere.error) + 1e-3 * usual.everywhere.mean)
            << size << ' ' << x;
    }
}

// Contrast of 1e9: a bulb a centimetre above a tile, in a hall of 600 m: each of both as bright as it is.
TEST(Sizes, ContrastOfABillion) {
    SceneFile file;
    const int black = file.material(0);
    file.quad("tile", {-0.005f, 0, 0.005f}, {0.01f, 0, 0}, {0, 0, -0.01f}, black);
    file.quad("wall", {-300, -300, -300}, {600, 0, 0}, {0, 600, 0}, black);
    file.bulb(1, {0, 0.01, 0});
    const double half = 0.5;  // of the tile in heights: solid angle 4 asin(h^2 / (1 + h^2))
    expect_value(solved(file, photons_a_size).on("tile"), 4 * std::asin(half * half / (1 + half * half)) / 1e-4,
                 "tile");
    expect_value(solved(file, photons_a_size).on("wall"), 4 * pi / 6 / (600.0 * 600), "wall");  // one of a cube's six
}

}  // namespace
}  // namespace brewster
