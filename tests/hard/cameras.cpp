// Eyes where none should be: pictures that hold numbers, whatever they show.
#include <gtest/gtest.h>

#include <cmath>

#include "app/process.h"
#include "hard/hard.h"
#include "image/exr.h"

namespace brewster {
namespace {

TEST(Cameras, InAWallOnAFaceAndInALamp) {
    const std::string folder = fresh_folder();
    SceneFile file;
    file.box("room", glm::vec3(0), glm::vec3(1), true, file.material(0.5));
    file.box("block", glm::vec3(0.4f), glm::vec3(0.6f), false, file.material(0.5));
    file.quad("lamp", {0.25f, 1, 0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f}, file.material(0, 10));
    file.camera("inside", {0.5, 0.5, 0.5});
    file.camera("on the face", {0.5, 0.5, 0.6});
    file.camera("in the plane", {0.5, 0, 0.9});
    file.camera("in the lamp", {0.5, 1, 0.5});
    write_text(folder + "/hard.gltf", file.text());
    const ProcessResult shot =
        run_process({brewster_program(), "shot", folder + "/hard.gltf", "--photons", "20000", "--size", "24x24",
                     "--samples", "4", "--camera", "all", "--out", folder + "/{camera}.exr"});
    ASSERT_EQ(shot.exit_code, 0) << shot.errors;
    for (const char* name : {"inside", "on the face", "in the plane", "in the lamp"}) {
        const Image picture = read_exr(folder + "/" + name + ".exr");
        for (int band = 0; band < 3; ++band)
            for (const float value : picture.channel(stokes_channel(0, band)))
                ASSERT_TRUE(std::isfinite(value) && value >= 0) << name;
    }
}

}  // namespace
}  // namespace brewster
