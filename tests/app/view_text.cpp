#include "app/view_text.h"

#include <gtest/gtest.h>

#include <fstream>
#include <glm/geometric.hpp>
#include <random>

#include "app/process.h"
#include "base/error.h"

namespace brewster {
namespace {

TEST(ViewText, WordsAreTaken) {
    const View view = parse_view(
        "camera=front  size=640x480 ev=-1.5\tmap=dolp palette=red-green analyzer=30 polarization=off gather=on "
        "samples=1e3 "
        "seed=7");
    EXPECT_EQ(view.camera, "front");
    EXPECT_FALSE(view.pose);
    EXPECT_EQ(view.size, (PictureSize{640, 480}));
    EXPECT_EQ(view.exposure, -1.5);
    EXPECT_EQ(view.map, Map::dolp);
    EXPECT_EQ(view.palette, Palette::red_green);
    EXPECT_EQ(view.analyzer, (Analyzer{Analyzer::Kind::linear, 30}));
    EXPECT_EQ(view.polarization, false);
    EXPECT_EQ(view.gather, true);
    EXPECT_EQ(view.samples, 1000);
    EXPECT_EQ(view.seed, 7u);
    EXPECT_EQ(parse_view(""), View{});
    EXPECT_EQ(parse_view("camera=\"two words\"").camera, "two words");
    EXPECT_EQ(parse_view("eye=1,2,3 target=0,-.5,1e-3").pose->target, glm::dvec3(0, -0.5, 1e-3));
}

TEST(ViewText, ReadsBackWhatItWrites) {
    std::mt19937 random(4);
    const auto uniform = [&] { return std::uniform_real_distribution(-1e3, 1e3)(random); };
    const auto maybe = [&] { return random() % 2 == 0; };
    for (int i = 0; i < 500; ++i) {
        View view;
        if (maybe()) view.camera = maybe() ? "front" : "from \u00e9, the = door";
        if (maybe())
            view.pose = {
                {uniform(), uniform(), uniform()}, {uniform(), uniform(), uniform()}, {0.1, uniform(), 0}, 33.3};
        if (maybe()) view.size = PictureSize{1 + static_cast<int>(random() % 2000), 77};
        if (maybe()) view.exposure = uniform() / 100;
        if (maybe()) view.map = map_descriptions[random() % map_descriptions.size()].map;
        if (maybe()) view.palette = Palette::polanalyser;
        if (maybe()) view.analyzer = Analyzer{Analyzer::Kind::linear, uniform()};
        if (maybe()) view.polarization = maybe();
        if (maybe()) view.gather = maybe();
        if (maybe()) view.samples = 64;
        if (maybe()) view.seed = std::uint64_t{random()} << 32;
        EXPECT_EQ(parse_view(view_text(view)), view) << view_text(view);
    }
}

TEST(ViewText, WhatIsWrongIsNamed) {
    for (const auto& [text, part] :
         std::vector<std::pair<const char*, const char*>>{{"front", "front"},
                                                          {"mapp=dolp", "did you mean 'map'"},
                                                          {"map=heat", "heat"},
                                                          {"eye=1,2,3", "target"},
                                                          {"eye=1,2 target=0,0,0", "eye"},
                                                          {"eye=1,2,3,4 target=0,0,0", "eye"},
                                                          {"camera=\"front", "quote"},
                                                          {"fov=200", "fov"},
                                                          {"samples=0", "samples"},
                                                          {"gather=maybe", "gather"}}) {
        try {
            parse_view(text);
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

Scene box() {
    return read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/cornell-box.gltf");
}

// The clipboard's promise: the same camera, so the same picture. Directions are floats of length 1.
TEST(ViewText, PosesDescribeTheirCamera) {
    Scene scene = box();
    scene.centre = {1234.5, -0.1, 3e4};
    for (const Camera& camera : scene.cameras) {
        View view;
        view.pose = pose_of(scene, camera);
        const Camera again = camera_of(scene, parse_view(view_text(view)));
        EXPECT_EQ(again.position, camera.position);
        EXPECT_LT(glm::distance(again.forward, camera.forward), 2e-7f);
        EXPECT_LT(glm::distance(again.up, camera.up), 2e-7f);
        EXPECT_FLOAT_EQ(again.vertical_field_of_view, camera.vertical_field_of_view);
        EXPECT_EQ(again.name, "view");
    }
    EXPECT_THROW(camera_of(scene, parse_view("eye=1,1,1 target=1,1,1")), Error);
    EXPECT_THROW(parse_view("eye=1e39,1,1 target=1,1,1"), Error);
    EXPECT_THROW(camera_of(scene, parse_view("eye=0,0,0 target=0,2,0")), Error);
    EXPECT_THROW(camera_of(scene, parse_view("camera=frnt")), Error);
}

TEST(ViewText, ViewsBecomeCamerasBesideTheScenes) {
    Scene scene = box();
    ShotOptions options;
    for (const char* text : {"camera=low", "camera=front eye=0,1,3 target=0,1,0", "eye=0,1,2 target=0,1,0 map=s1"})
        apply_view(parse_view(text), options);
    EXPECT_EQ(options.maps, (std::vector<Map>{Map::s1}));
    const Camera front = scene.camera("front");
    add_views(scene, options);
    EXPECT_EQ(options.cameras, (std::vector<std::string>{"low", "front (moved)", "view"}));
    EXPECT_EQ(scene.camera("front").position, front.position) << "the exposure hangs on it";
    EXPECT_EQ(scene.camera("view").forward, glm::vec3(0, 0, -1));
}

TEST(ViewText, FilesHoldOneViewALine) {
    const std::string path = fresh_folder() + "/views.txt";
    write_text(path, "# round the block\n\ncamera=a eye=0,1,2 target=0,0,0\n  camera=b eye=1,1,2 target=0,0,0\r\n");
    const std::vector<View> views = read_views(path);
    ASSERT_EQ(views.size(), 2u);
    EXPECT_EQ(views[1].camera, "b");
    EXPECT_THROW(read_views(path + ".missing"), Error);
}

}  // namespace
}  // namespace brewster
