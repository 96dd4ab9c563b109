#include <gtest/gtest.h>

#include "gather/gather_test.h"
#include "image/compare.h"
#include "image/exr.h"
#include "optics/random_light.h"
#include "reference/hand_made.h"
#include "reference/reference.h"
#include "scene/test_materials.h"

/// Gathered pictures against the reference, which shares scene, optics and rays but nothing that estimates.
namespace brewster {
namespace {

/// Mean of every Stokes component, polarization on and off, within 3.5 of both pictures' standard errors; the bins' own
/// error is common to their pixels, so it is added as if all of them were one leaf, at most `bins_share` of the light.
void expect_agreement(const std::string& what, const StokesPicture& picture, const Image& reference, bool polarized,
                      double bins_share) {
    const PictureDifference difference = compare(stokes_image(picture, polarized), reference);
    for (std::size_t component = 0; component < (polarized ? 4u : 1u); ++component)
        for (std::size_t band = 0; band < band_count; ++band) {
            const BandDifference& found = (*difference.components[component])[band];
            const double bins_error = bins_share * (*difference.components[0])[band].mean_b;
            EXPECT_NEAR(found.bias, 0, 3.5 * *found.bias_standard_error + bins_error)
                << what << " S" << component << " band " << band << " polarized " << polarized;
            // So that a fault of 4 % would be noticed.
            if (light_test_scale == 1 && component == 0) {
                EXPECT_LT(3.5 * *found.bias_standard_error + bins_error, 0.04 * found.mean_b) << what;
            }
        }
}

/// Kept references (tests/images/reference). 1e6 photons know a picture's mean to about .2 %: their relative error is 4 %
/// in hundreds of cells.
TEST(GatherAgainstReference, CanonicalScenes) {
    constexpr std::uint64_t photons = 1'000'000 / static_cast<unsigned>(light_test_scale);
    constexpr std::uint32_t draws = light_test_scale == 1 ? 64 : 4;
    for (const auto& view : std::vector<std::pair<std::string, std::string>>{
             {"cornell-box", "front"}, {"gloss-lab", "entry"}, {"metal-lab", "low"}, {"spheres", "side"}}) {
        const std::string &name = view.first, &camera = view.second;
        const auto scene = scene_of_assets(name);
        const auto bins = solved_bins(scene, photons);
        const auto kept = [&](const std::string& world) {
            return read_exr(BREWSTER_SOURCE_DIR "/tests/images/reference/" + name + "-" + camera + world + ".exr");
        };
        const Image on = kept(""), off = name == "cornell-box" ? on : kept("-off");
        const StokesPicture picture = gathered(scene, bins, scene->camera(camera), on.width(), on.height(), draws);
        const double bins_share = 0.005 * std::sqrt(light_test_scale);
        expect_agreement(name, picture, on, true, bins_share);
        expect_agreement(name, picture, off, false, bins_share);
    }
}

/// Everything at once: rough metal, waves on plastic, a pane, a glass body, a mirror, under a polarized sun's disc and an
/// area lamp.
TEST(GatherAgainstReference, RoomOfAllThings) {
    HandMade room;
    const auto wall = room.add(grey(0.6f)), lamp = room.add(emitter(glm::vec3(5.0f)));
    const auto metal = room.add(test_materials::beckmann(test_materials::gold(), 0.3f));
    const auto waves =
        room.add(test_materials::kirchhoff(test_materials::dielectric(Base::polarized_diffuse), 0.15f, 2.5f));
    room.square("floor", {0, 0, 0}, {0, 1, 0}, 2, metal);
    room.square("back", {0, 2, -2}, {0, 0, 1}, 2, waves);
    room.square("side", {-2, 2, 0}, {1, 0, 0}, 2, wall);
    room.square("mirror", {2, 2, 0}, {-1, 0, 0}, 1, room.add(test_materials::gold()));
    room.square("lamp", {0, 3.5, 0}, {0, -1, 0}, 0.5, lamp);
    room.square("pane", {-0.8, 1, 0.6}, {0.2, 0, 1}, 0.5, room.add(test_materials::pane()));
    room.box("glass", {0.3f, 0.2f, -0.6f}, {0.9f, 1.0f, 0.2f}, false,
             room.add(test_materials::dielectric(Base::transparent)));
    Lamp sun;
    sun.kind = LampKind::sun;
    sun.intensity = glm::vec3(3.0f);
    sun.direction = glm::vec3(glm::normalize(glm::dvec3(-0.5, -1, -0.6)));
    sun.angular_radius = 0.1f;
    sun.polarization = {0.5f, 0.3f, 0.4f};
    room.lamp(sun);
    const auto scene = room.finish();
    const auto bins = solved_bins(scene, 1'000'000 / static_cast<unsigned>(light_test_scale));
    const Camera camera = looking({0.4, 1.8, 5}, {0, 1.2, 0}, 45);
    const StokesPicture picture = gathered(scene, bins, camera, 40, 30, light_test_scale == 1 ? 256 : 32);
    for (const bool polarized : {true, false}) {
        Reference reference(*scene, camera, 40, 30, polarized, 99, 2);
        reference.add_samples(200 / static_cast<unsigned>(light_test_scale));
        expect_agreement("room", picture, reference.picture(), polarized, 0.005);
    }
}

}  // namespace
}  // namespace brewster
