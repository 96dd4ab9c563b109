// The whole path, from glTF to pixels, against pictures of the same scene by Mitsuba 3 (tests/images/peer).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <string>

#include "display/picture.h"
#include "engine/engine.h"
#include "gl_test.h"
#include "image/compare.h"
#include "image/exr.h"

namespace brewster {
namespace {

class Peer : public GlTest {
  protected:
    /// A million photons in the Cornell box with lamps so much brighter.
    static std::unique_ptr<Engine> solved(float lamp_factor) {
        Scene scene = read_scene(root + "/assets/scenes/cornell-box.gltf");
        for (Lamp& lamp : scene.lamps) {
            lamp.power *= lamp_factor;
            lamp.intensity *= lamp_factor;
        }
        EngineSettings settings;
        settings.seed = 3;
        auto engine = std::make_unique<Engine>(std::make_shared<const Scene>(std::move(scene)), settings);
        StopRule rule;
        rule.photons = 1000000;
        engine->start(rule);
        engine->wait();
        return engine;
    }

    static PictureDifference against_peer(const Engine& engine, const std::string& camera) {
        Picture picture(engine.scene());
        picture.show(engine.snapshot());
        picture.upload();
        picture.look(engine.scene().camera(camera), 96, 96);
        picture.draw(Picture::full_draws);
        return compare(picture.stokes(), read_exr(root + "/tests/images/peer/cornell-box-" + camera + ".exr"));
    }

    static inline const std::string root = BREWSTER_SOURCE_DIR;
};

// A million photons: the direct flux is stratified, the indirect one has relative errors below 3 / sqrt(1e6) = 0.3 %
// for the whole box; a camera that sees one corner of it, with a thirtieth of the light, five times that.
TEST_F(Peer, MeanRadianceAgrees) {
    const auto engine = solved(1);
    for (const auto& [camera, bound] : {std::pair("front", 0.01), std::pair("inside", 0.01), std::pair("low", 0.02)}) {
        const PictureDifference difference = against_peer(*engine, camera);
        for (const BandDifference& band : *difference.components[0]) {
            EXPECT_LT(std::abs(band.bias) / band.mean_b, bound) << camera;
            EXPECT_LT(band.relative_rmse, 0.1) << camera;
        }
    }
}

TEST_F(Peer, ThreePercentMoreLampPowerIsNoticed) {
    const PictureDifference difference = against_peer(*solved(1.03f), "inside");
    for (const BandDifference& band : *difference.components[0]) EXPECT_GT(band.bias / band.mean_b, 0.01);
}

}  // namespace
}  // namespace brewster
