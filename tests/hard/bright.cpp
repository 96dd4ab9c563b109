// Light that stays, light of every strength.
#include <gtest/gtest.h>

#include "base/units.h"
#include "engine/slow.h"
#include "hard/hard.h"

namespace brewster {
namespace {

// A closed room that keeps 0.999 of its light, a bulb in it: I 4 pi / ((1 - rho) area), each photon a thousand bounces.
TEST(Bright, WhiteRoomKeepsItsLight) {
    SceneFile file;
    file.box("room", glm::vec3(-1), glm::vec3(1), true, file.material(0.999));
    file.bulb(1, {0.1, 0.2, 0.3});
    constexpr std::uint64_t photons = slow ? 100 : 800;
    const Solved result = solved(file, photons);
    std::printf("%.0f bounces a photon\n", static_cast<double>(result.bounces) / (8.0 * static_cast<double>(photons)));
    expect_value(result.everywhere, 4 * pi / (0.001 * 24), "white room");
    EXPECT_EQ(result.escaped, 0);
}

// The same room and lamp, from the faintest to the brightest that is read; beyond, a sentence.
TEST(Bright, RadianceOfAnyStrength) {
    const auto lit = [](double radiance) {
        SceneFile file;
        file.box("room", glm::vec3(0), glm::vec3(1), true, file.material(0.5));
        file.quad("lamp", {0.25f, 0.99f, 0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f},
                  file.material(0, 1,
                                R"({"extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": )" +
                                    digits(radiance) + "}}}"));
        return file;
    };
    const double of_one = solved(lit(1), 20000, {}, 2).on("room").mean;
    for (const double radiance : {1e-30, 1e12})
        EXPECT_NEAR(solved(lit(radiance), 20000, {}, 2).on("room").mean / radiance, of_one, 1e-5 * of_one);
    EXPECT_NE(sentence_of(lit(1e30)).find("out of range"), std::string::npos);
}

}  // namespace
}  // namespace brewster
