// Interfaces of every index and finish: never more light than came.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/slow.h"
#include "hard/hard.h"
#include "scene/bsdf.h"
#include "scene/test_materials.h"

namespace brewster {
namespace {

std::string index_of(double n, double roughness) {
    return R"({"extensions": {"KHR_materials_specular": null, "KHR_materials_ior": {"ior": )" + digits(n) +
           R"(}}, "pbrMetallicRoughness": {"roughnessFactor": )" + digits(roughness) + "}}";
}

TEST(Index, HardlyMoreThanAirIsNoInterface) {
    SceneFile file;
    file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, file.material(0.5, 0, index_of(1.0000001, 0)));
    EXPECT_EQ(file.read().materials[0].interface.kind, InterfaceKind::none);
}

TEST(Index, LessThanAirIsSaid) {
    SceneFile file;
    file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, file.material(0.5, 0, index_of(0.8, 0)));
    EXPECT_NE(sentence_of(file).find("ior\" is 0.800000, out of range"), std::string::npos);
}

// A furnace of plastic of index 10 with a glowing core: the base keeps nearly all it gets, and every account balances.
TEST(Index, OfTen) {
    SceneFile file;
    file.box("room", glm::vec3(-1), glm::vec3(1), true, file.material(0.9, 0, index_of(10, 0.5)));
    file.bulb(1, {0, 0, 0});
    const Solved result = solved(file, slow ? 2000 : 10000, {}, 2);
    EXPECT_LT(result.escaped, 1e-4);
}

TEST(Index, JustBesideTheCriticalAngle) {
    constexpr double n = 1 / 1.5;
    const double critical = std::asin(n);
    for (const double beside : {-1e-9, -1e-12, 0.0, 1e-12, 1e-9}) {
        const auto light = planar(dielectric_interface(std::cos(critical + beside), n).reflection);
        EXPECT_LE(light.m00, 1 + 1e-15) << beside;
        // What passes begins with the root of the distance: 4 sqrt(2 x cos) / ... stays below 20 sqrt(x).
        EXPECT_GE(light.m00, 1 - 20 * std::sqrt(std::max(-beside, 0.0)) - 1e-7) << beside;
        const auto single = planar(
            dielectric_interface(static_cast<float>(std::cos(critical + beside)), static_cast<float>(n)).reflection);
        EXPECT_LE(single.m00, 1.0f + 1e-6f);
        EXPECT_TRUE(std::isfinite(single.m00 + single.c + single.d));
    }
}

// Samples of materials at the corners of what may be read: their mean weight, the albedo, stays within 1.
TEST(Index, NoCornerMakesLight) {
    using namespace test_materials;
    std::vector<Material> corners;
    const auto metal = [](float n, float k) {
        return over(InterfaceKind::conductor, glm::vec3(n), glm::vec3(k), Base::black);
    };
    for (const float m : {0.001f, 0.01f, 0.1f, 0.8f})
        for (const Material& material :
             {metal(1e-3f, 1e-6f), metal(1.5f, 0), metal(0.2f, 0), metal(1, 100), metal(100, 100), metal(0.05f, 4),
              dielectric(Base::polarized_diffuse, glm::vec3(1.01f)), dielectric(Base::polarized_diffuse, glm::vec3(10)),
              dielectric(Base::polarized_diffuse, glm::vec3(100))})
            corners.push_back(beckmann(material, m));
    for (const auto& [height, length] : {std::pair(1e-6f, 1e4f), {1e-6f, 1e-5f}, {0.4e4f, 1e4f}, {0.1f, 0.25f}})
        for (const Material& material : {metal(0.2f, 3), dielectric(Base::polarized_diffuse)})
            corners.push_back(kirchhoff(material, height, length));
    const std::vector<PreparedMaterial> materials = prepare_materials(corners);
    const int draws = slow ? 300 : 3000;
    for (std::size_t i = 0; i < materials.size(); ++i)
        for (const float cosine : {1.0f, 0.5f, 0.01f, 1e-4f}) {
            const Vector<float> normal{0, 0, 1}, towards{std::sqrt(1 - cosine * cosine), 0, cosine};
            SurfacePoint<float> at{towards, {0, 1, 0}, normal, false, {1, 0, 0}};
            double sum = 0, squares = 0;
            for (int k = 0; k < draws; ++k) {
                const auto part = [&](double step) { return static_cast<float>(std::fmod(0.5 + k * step, 1.0)); };
                const ScatterNumbers<float> numbers{part(0.754877666), part(0.569840291), part(0.430159709),
                                                    part(0.618033989), part(0.324717957), part(0.245122334),
                                                    part(0.819172513)};
                const auto sample = sample_bsdf<Use::light, 1>(materials[i], at, numbers);
                if (!sample.alive) continue;
                const double weight = static_cast<double>(sample.weight[0].m00);
                ASSERT_TRUE(std::isfinite(weight) && weight >= 0) << i << ' ' << cosine << ' ' << weight;
                sum += weight / draws;
                squares += weight * weight / draws;
            }
            const double error = std::sqrt(std::max(squares - sum * sum, 0.0) / draws);
            EXPECT_LE(sum, 1.002 + 4 * error) << i << ' ' << cosine;
        }
}

}  // namespace
}  // namespace brewster
