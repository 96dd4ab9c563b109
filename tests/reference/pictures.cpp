#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "image/blocks.h"
#include "image/compare.h"
#include "image/exr.h"
#include "optics/random_light.h"
#include "reference/reference.h"

/// The pictures of tests/images/reference, which others are judged by: against another renderer's (tests/images/peer)
/// and against what the code makes today.
namespace brewster {
namespace {

const std::string root = BREWSTER_SOURCE_DIR;

Scene stored_asset(const std::string& name) {
    return read_scene(root + "/assets/scenes/" + name + ".gltf");
}

Image stored(const std::string& folder, const std::string& name) {
    return read_exr(root + "/tests/images/" + folder + "/" + name + ".exr");
}

/// What both are compared by: bias of S0, and S1 to S3 in blocks of 8 x 8 pixels beyond the noise, all over the mean S0.
struct Agreement {
    double bias = 0, bias_error = 0;
    std::array<double, 4> blocks{};
};

Agreement agreement(const Image& ours, const Image& peer, int band, std::span<const std::uint8_t> mask = {}) {
    const auto at = static_cast<std::size_t>(band);
    const PictureDifference pixels = compare(ours, peer, mask);
    const BandDifference& s0 = (*pixels.components[0])[at];
    Agreement result{s0.bias / s0.mean_b, *s0.bias_standard_error / s0.mean_b, {}};
    const Blocks ours_blocks = block_means(ours, 8, mask), peer_blocks = block_means(peer, 8, mask);
    const PictureDifference blocks = compare(ours_blocks.image, peer_blocks.image, peer_blocks.mask);
    for (std::size_t j = 0; j < 4; ++j)
        if (blocks.components[j]) result.blocks[j] = (*blocks.components[j])[at].rmse_beyond_noise / s0.mean_b;
    return result;
}

/// Means within .5 % (the peer's shadowing term may be .35 % off), Stokes vectors of blocks within .5 % of S0.
TEST(Pictures, AgreeWithThePeer) {
    for (const char* name :
         {"cornell-box-front", "cornell-box-inside", "cornell-box-low", "gloss-lab-entry", "gloss-lab-left",
          "gloss-lab-low", "metal-lab-entry", "metal-lab-low", "spheres-front", "spheres-side"}) {
        const Image ours = stored("reference", name), peer = stored("peer", name);
        for (int band = 0; band < band_count; ++band) {
            const Agreement found = agreement(ours, peer, band);
            std::printf("%-20s %c: bias %+.3f %% +- %.3f %%; blocks S0 %.2f %%, S1 %.2f %%, S2 %.2f %%, S3 %.2f %%\n",
                        name, band_letters[static_cast<std::size_t>(band)], 100 * found.bias, 100 * found.bias_error,
                        100 * found.blocks[0], 100 * found.blocks[1], 100 * found.blocks[2], 100 * found.blocks[3]);
            EXPECT_LT(std::abs(found.bias), 0.005) << name;
            for (std::size_t j = 1; j < 4; ++j) EXPECT_LT(found.blocks[j], 0.005) << name << " S" << j;
        }
    }
}

/// Flipped handedness or a wrong axis would be seen: at least .1 % of S0, and three times what there is.
TEST(Pictures, AWrongSignWouldBeNoticed) {
    for (const auto& [name, component] : {std::pair("metal-lab-low", 3), std::pair("gloss-lab-low", 2)}) {
        const auto j = static_cast<std::size_t>(component);
        const Image peer = stored("peer", name);
        Image ours = stored("reference", name);
        const double right = agreement(ours, peer, 0).blocks[j];
        for (float& x : ours.channel(stokes_channel(component, 0))) x = -x;
        EXPECT_GT(agreement(ours, peer, 0).blocks[j], 0.001 + 3 * right) << name;
    }
}

/// Pixels whose centre and corners show a base.
std::vector<std::uint8_t> bases_seen(const Surroundings& surroundings, const Camera& camera, int width, int height) {
    std::vector<std::uint8_t> mask;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            bool all = true;
            for (const auto& [x, y] : {std::pair(0.5f, 0.5f), {0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 1.0f}}) {
                const glm::vec3 ray =
                    ray_direction(camera, width, height, static_cast<float>(column) + x, static_cast<float>(row) + y);
                const auto met = surroundings.look(vector_of(camera.position), normalized(vector_of(ray)));
                all = all && met.vertex && met.vertex->material->diffuse();
            }
            mask.push_back(all);
        }
    return mask;
}

/// The peer traced light without polarization; its glossy floor is noisy, its walls are not.
TEST(Pictures, RoomAgreesWithThePeerOnTheWalls) {
    const Scene scene = stored_asset("brewster-room");
    const Surroundings surroundings(scene);
    for (const Camera& camera : scene.cameras) {
        const std::string name = "brewster-room-" + camera.name + "-off";
        const Image ours = stored("reference", name), peer = stored("peer", name);
        const auto mask = bases_seen(surroundings, camera, ours.width(), ours.height());
        for (int band = 0; band < band_count; ++band) {
            const Agreement found = agreement(ours, peer, band, mask);
            std::printf("%-28s %c: bias %+.3f %% +- %.3f %%, blocks %.2f %%\n", name.c_str(),
                        band_letters[static_cast<std::size_t>(band)], 100 * found.bias, 100 * found.bias_error,
                        100 * found.blocks[0]);
            EXPECT_LT(std::abs(found.bias), 0.01) << name;
        }
    }
}

/// Means do not depend on the number of pixels: small pictures of today against the stored ones, S0 to S3 of a band,
/// each within 4 standard errors (of 100 one fails with probability 6e-3 for one seed, and this seed passes).
TEST(Pictures, AreWhatTheTracersMakeToday) {
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root + "/tests/images/reference")) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() != ".exr" || name.ends_with("320x240")) continue;
        const Image picture = read_exr(entry.path().string());
        std::map<std::string, std::string> said(picture.attributes.begin(), picture.attributes.end());
        const Scene scene = stored_asset(said["brewster.scene"]);
        const bool polarized = said["brewster.polarization"] == "on";
        Reference today(scene, scene.camera(said["brewster.camera"]), picture.width() / 8, picture.height() / 8,
                        polarized, 99, 2);
        today.add_samples(light_test_scale == 1 ? 60 : 24);  // beyond the pilot: the room needs its photons
        const Image small = today.picture();
        for (int j = 0; j < (polarized ? 4 : 1); ++j) {
            const PictureMean now = mean_of(small, j, 1), then = mean_of(picture, j, 1);
            EXPECT_NEAR(now.mean, then.mean, 4 * std::hypot(now.standard_error, then.standard_error) + 1e-9)
                << name << " S" << j;
        }
        ++compared;
    }
    EXPECT_GE(compared, 24);
}

}  // namespace
}  // namespace brewster
