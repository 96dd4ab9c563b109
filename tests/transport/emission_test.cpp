#include "transport/emission.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rooms.h"

namespace brewster {
namespace {

Scene two_points() {
    Scene scene;
    scene.name = "two points";
    scene.low = glm::vec3(-1);
    scene.high = glm::vec3(1);
    for (const float candela : {1.0f, 3.0f}) {
        Lamp lamp;
        lamp.kind = LampKind::point;
        lamp.position = {candela, 0, 0};
        lamp.intensity = candela * glm::vec3(2, 1, 0);
        lamp.power = point_power(lamp.intensity);
        scene.lamps.push_back(lamp);
    }
    return scene;
}

TEST(PhotonEmission, LampsGetPhotonsByTheirPower) {
    const Scene scene = two_points();
    const PhotonEmission emission(scene, 4);
    EXPECT_NEAR(emission.mean_power(), 4 * 4 * pi, 1e-4);
    constexpr std::uint64_t n = 8 * 4096;
    std::uint64_t bright = 0;
    for (std::uint64_t photon = 0; photon < n; ++photon) bright += emission.sample(photon).start.position.x > 2;
    // Stratified: each replica may be off by one photon.
    EXPECT_NEAR(static_cast<double>(bright), 0.75 * n, 8);
}

TEST(PhotonEmission, WeightsHaveBandMeanOne) {
    const Scene scene = two_points();
    const PhotonEmission emission(scene, 4);
    for (std::uint64_t photon = 0; photon < 100; ++photon) {
        const std::array<float, 3> weight = emission.sample(photon).weight;
        EXPECT_NEAR((weight[0] + weight[1] + weight[2]) / 3, 1, 1e-6);
        EXPECT_NEAR(weight[0], 2, 1e-6);
        EXPECT_EQ(weight[2], 0);
    }
}

TEST(PhotonEmission, PhotonsFarApartStillDiffer) {
    const Scene scene = two_points();
    const PhotonEmission emission(scene, 4);
    const std::uint64_t period = std::uint64_t{1} << 35;  // eight replicas of 2^32 points
    EXPECT_NE(emission.sobol(5, 1), emission.sobol(5 + period, 1));
    EXPECT_EQ(emission.sobol(5, 1), emission.sobol(5, 1));
}

TEST(PhotonEmission, SeedsAndReplicasDiffer) {
    const Scene scene = two_points();
    EXPECT_NE(PhotonEmission(scene, 1).sobol(0, 1), PhotonEmission(scene, 2).sobol(0, 1));
    EXPECT_NE(PhotonEmission(scene, 1).sobol(0, 1), PhotonEmission(scene, 1).sobol(1, 1));
}

TEST(PhotonEmission, NoPowerIsSaid) {
    Scene scene = two_points();
    for (Lamp& lamp : scene.lamps) lamp.power = glm::vec3(0);
    EXPECT_FALSE(PhotonEmission(scene, 1).any());
}

}  // namespace
}  // namespace brewster
