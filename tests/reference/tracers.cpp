#include <gtest/gtest.h>

#include "optics/random_light.h"
#include "reference/hand_made.h"
#include "reference/path_flux.h"
#include "reference/reference.h"
#include "reference/samples.h"
#include "scene/test_materials.h"

/// Camera and light tracer against each other, class by class of paths, and what both must keep.
namespace brewster {
namespace {

const char* const class_names[] = {"bases", "reflections", "caustics"};
constexpr PathClass shared_classes[] = {PathClass::bases, PathClass::reflections, PathClass::caustics};

std::shared_ptr<const Scene> asset(const std::string& name) {
    return std::make_shared<const Scene>(
        read_scene(std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/" + name + ".gltf"));
}

struct Pair {
    PictureMean camera, light;
};

/// Band 0 of a class, by either tracer. Pictures of 16 x 12 pixels: what is compared is their mean.
std::array<Pair, 4> both(const Scene& scene, const Camera& camera, PathClass one, std::uint64_t samples,
                         bool polarized = true) {
    const Surroundings surroundings(scene);
    const TracerSettings settings{polarized, static_cast<PathClasses>(one), 1};
    CameraTracer from_camera(surroundings, camera, 16, 12, settings);
    LightTracer from_lamps(surroundings, camera, 16, 12, settings);
    from_camera.add_samples(scaled(samples), threads);
    from_lamps.add_photons(192 * scaled(samples), threads);
    Image a(16, 12), b(16, 12);
    from_camera.sums().add_to(a, from_camera.samples());
    from_lamps.sums().add_to(b, std::max<std::uint64_t>(from_lamps.photons(), 1));
    std::array<Pair, 4> pairs;
    for (int j = 0; j < 4; ++j) pairs[static_cast<std::size_t>(j)] = {mean_of(a, j, 0), mean_of(b, j, 0)};
    return pairs;
}

void expect_agreement(const std::string& what, const std::array<Pair, 4>& pairs) {
    const double s0 = pairs[0].camera.mean;
    for (std::size_t j = 0; j < 4; ++j) {
        const double difference = pairs[j].light.mean - pairs[j].camera.mean;
        const double error = std::hypot(pairs[j].light.standard_error, pairs[j].camera.standard_error);
        if (j == 0)
            std::printf("%-36s %.5g by camera, %.5g by light: %+.2f %% +- %.2f %%\n", what.c_str(), s0,
                        pairs[0].light.mean, 100 * difference / s0, 100 * error / s0);
        // 4 standard errors each: 60 comparisons fail with probability 4e-3 for one seed, and this seed passes.
        EXPECT_NEAR(difference, 0, 4 * error + 1e-9 * s0) << what << " S" << j;
    }
}

void add(PictureMean& sum, const PictureMean& part) {
    sum = {sum.mean + part.mean, std::hypot(sum.standard_error, part.standard_error)};
}

/// Four scenes of the assets, each class that both tracers can render, and all of them together.
TEST(Tracers, AgreeClassByClass) {
    for (const char* name : {"cornell-box", "gloss-lab", "metal-lab", "spheres"}) {
        const auto scene = asset(name);
        std::array<Pair, 4> together{};
        for (std::size_t k = 0; k < 3; ++k) {
            if (k > 0 && std::string(name) == "cornell-box") continue;
            // Few samples miss rare reflections between metals, and their errors with them: sanitizers take a fifth.
            const std::uint64_t samples = light_test_scale == 1 ? 2000 : 4000;
            const auto pairs = both(*scene, scene->cameras.front(), shared_classes[k], samples);
            EXPECT_GT(pairs[0].camera.mean, 0);
            expect_agreement(std::string(name) + ", " + class_names[k], pairs);
            for (std::size_t j = 0; j < 4; ++j) {
                add(together[j].camera, pairs[j].camera);
                add(together[j].light, pairs[j].light);
            }
            if (k == 0 && light_test_scale == 1) {
                // The control: 5 % more light on one side would be noticed.
                EXPECT_GT(std::abs(1.05 * pairs[0].light.mean - pairs[0].camera.mean),
                          4 * std::hypot(1.05 * pairs[0].light.standard_error, pairs[0].camera.standard_error));
            }
        }
        expect_agreement(std::string(name) + ", together", together);
    }
}

std::shared_ptr<const Scene> room_with(const Material& floor_material, const Material& thing_material,
                                       const Lamp* extra = nullptr) {
    HandMade room;
    const auto wall = room.add(grey(0.6f)), floor = room.add(floor_material), thing = room.add(thing_material);
    const auto lamp = room.add(emitter({8.0f, 6.0f, 4.0f}));
    room.box("wall", {-2, -2, -0.01f}, {2, 2, 3}, true, wall);
    room.square("floor", {0, 0, 0}, {0, 0, 1}, 1.9, floor);
    room.box("thing", {-0.5f, -0.6f, 0.3f}, {0.6f, 0.5f, 0.9f}, false, thing);
    if (extra) {
        Lamp lamp_without_extent = *extra;
        room.lamp(lamp_without_extent);
    } else {
        room.square("lamp", {0.2, 0.1, 2.9}, {0, 0, -1}, 0.8, lamp);
    }
    return room.finish();
}

const Camera room_camera = looking({1.5, -1.6, 1.9}, {0, 0, 0.2}, 60);

/// Refraction, both uses of it: light through a glass block onto a floor.
TEST(Tracers, AgreeBehindGlass) {
    const auto scene = room_with(grey(0.7f), test_materials::dielectric(Base::transparent));
    expect_agreement("glass block, caustics", both(*scene, room_camera, PathClass::caustics, 2000));
}

TEST(Tracers, AgreeBehindPanes) {
    const auto scene = room_with(grey(0.7f), test_materials::pane());
    expect_agreement("thin panes, caustics", both(*scene, room_camera, PathClass::caustics, 2000));
}

/// Polarized bases under smooth and rough interfaces beside metal of wave optics; also without polarization.
TEST(Tracers, AgreeOnPolarizedBases) {
    const Material plastic = test_materials::dielectric(Base::polarized_diffuse);
    const auto rough = room_with(test_materials::beckmann(plastic, 0.3f),
                                 test_materials::kirchhoff(test_materials::gold(), 0.05f, 0.5f));
    const auto smooth = room_with(plastic, test_materials::beckmann(test_materials::gold(), 0.3f));
    for (std::size_t k = 0; k < 3; ++k) {
        expect_agreement(std::string("rough plastic, ") + class_names[k],
                         both(*rough, room_camera, shared_classes[k], 800));
        expect_agreement(std::string("smooth plastic, ") + class_names[k],
                         both(*smooth, room_camera, shared_classes[k], 800));
    }
    expect_agreement("rough plastic, off, caustics", both(*rough, room_camera, PathClass::caustics, 800, false));
}

/// Lamps without extent, polarized ones.
TEST(Tracers, AgreeOnPolarizedLamps) {
    Lamp lamp;
    lamp.kind = LampKind::point;
    lamp.position = {0.3f, 0.2f, 2.5f};
    lamp.intensity = glm::vec3(5.0f);
    lamp.power = point_power(lamp.intensity);
    lamp.polarization = {0.5f, -0.4f, 0.6f};
    const Material gloss = test_materials::beckmann(test_materials::dielectric(Base::black), 0.3f);
    const auto scene = room_with(gloss, test_materials::beckmann(test_materials::gold(), 0.4f), &lamp);
    for (std::size_t k = 1; k < 3; ++k)
        expect_agreement(std::string("polarized point lamp, ") + class_names[k],
                         both(*scene, room_camera, shared_classes[k], 800));
}

std::vector<float> all_values(const Reference& reference) {
    std::vector<float> values;
    const Image picture = reference.picture();
    for (const std::string& name : picture.channel_names())
        values.insert(values.end(), picture.channel(name).begin(), picture.channel(name).end());
    return values;
}

/// The same bits for any number of threads, and in one go or several.
TEST(Tracers, SamplesAndSeedAreAllThatCounts) {
    const auto scene = asset("gloss-lab");
    const Camera& camera = scene->cameras.front();
    Reference one(*scene, camera, 20, 15, true, 7, 1), three(*scene, camera, 20, 15, true, 7, 3);
    Reference other(*scene, camera, 20, 15, true, 8, 1);
    one.add_samples(24);
    three.add_samples(5);
    three.add_samples(19);
    other.add_samples(24);
    EXPECT_EQ(all_values(one), all_values(three));
    EXPECT_NE(all_values(one), all_values(other));
}

/// The variance that is written belongs to the mean: over 24 seeds, the spread of a picture's mean and its claim.
TEST(Tracers, VarianceIsThatOfTheMean) {
    const auto scene = asset("gloss-lab");
    const int seeds = 24;
    double sum = 0, squares = 0, claimed = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        Reference reference(*scene, scene->cameras.front(), 8, 6, true, static_cast<std::uint64_t>(seed), threads);
        reference.add_samples(40);
        const PictureMean mean = mean_of(reference.picture(), 0, 1);
        sum += mean.mean;
        squares += mean.mean * mean.mean;
        claimed += mean.standard_error * mean.standard_error / seeds;
    }
    const double spread = (squares - sum * sum / seeds) / (seeds - 1);
    // A variance over 24 seeds is known to 29 %; 3.3 of that.
    EXPECT_NEAR(spread / claimed, 1, 0.97);
}

/// Stokes vectors of every pixel are realizable within their errors, and no number is broken.
TEST(Tracers, PicturesAreFinite) {
    const auto scene = room_with(test_materials::beckmann(test_materials::dielectric(Base::polarized_diffuse), 0.3f),
                                 test_materials::dielectric(Base::transparent));
    Reference reference(*scene, room_camera, 16, 12, true, 1, threads);
    reference.add_samples(60);
    for (const float value : all_values(reference)) ASSERT_TRUE(std::isfinite(value));
}

/// Figure 8.1 of the thesis at three roughnesses (theory 3.9): sun -> floor -> side -> back wall, on over off.
TEST(Tracers, FigureOfTheThesis) {
    const auto ratio_at = [](float slope, std::uint64_t photons) {
        Scene scene = *asset("brewster-room");
        for (Material& material : scene.materials)
            if (material.interface.present()) {
                material.interface.finish = slope > 0 ? Finish::beckmann : Finish::smooth;
                material.interface.slope = slope;
            }
        const Surroundings surroundings(scene);
        const PathFlux flux =
            path_flux(surroundings, {"floor", "cuboid side", "back wall"}, scaled(photons), 1, threads);
        std::printf("figure 8.1, m = %.2f: on/off %.4f %% +- %.4f %%, off %.5g lm\n", static_cast<double>(slope),
                    100 * flux.ratio, 100 * flux.ratio_standard_error, flux.unpolarized.mean[0]);
        return flux;
    };
    const PathFlux sharp = ratio_at(0, 300000), narrow = ratio_at(0.01f, 1000000), wide = ratio_at(0.04f, 1000000);
    EXPECT_NEAR(sharp.ratio, 2.0e-4, 2e-5 + 3 * sharp.ratio_standard_error);
    EXPECT_NEAR(narrow.ratio, 0.0057, 5e-4 + 3 * narrow.ratio_standard_error);
    EXPECT_NEAR(wide.ratio, 0.065, 3e-3 + 3 * wide.ratio_standard_error);
}

}  // namespace
}  // namespace brewster
