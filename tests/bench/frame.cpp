// What the look-up costs in a frame: bench_frame FRAMES SCENE...
// One draw of the first camera at 1280 x 720 from bins of 1e6 photons, as a window draws while the engine rests, and the
// same frame with each look-up replaced by a constant in the shader; medians of the frames, in turn, milliseconds.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "display/osmesa_context.h"
#include "display/picture.h"
#include "display/shader_source.h"
#include "engine/engine.h"

namespace {

using namespace brewster;
namespace fs = std::filesystem;

void replace(std::string& text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos)
        throw Error("does not hold \"" + what + "\"", "shaders/chart.glsl", "mend this benchmark");
    text.replace(at, what.size(), by);
}

/// A copy of the shaders that looks nothing up.
std::string constant_shaders() {
    const fs::path folder = fs::temp_directory_path() / "brewster-constant-shaders";
    fs::remove_all(folder);
    fs::copy(BREWSTER_SOURCE_DIR "/shaders", folder, fs::copy_options::recursive);
    std::ifstream file(folder / "chart.glsl");
    std::ostringstream content;
    content << file.rdbuf();
    std::string text = content.str();
    // The program sets all uniforms, so they must stay in use: asked for their size, which costs nothing.
    replace(text, "struct SeenBins {",
            "float next_to_nothing() {\n"
            "    return 1e-30 * float(textureSize(bin_nodes) + textureSize(bin_leaves) + textureSize(gloss_nodes) +\n"
            "                         textureSize(gloss_leaves) + gloss_components + int(shown_world.x) +\n"
            "                         int(unpolarized));\n"
            "}\n\nstruct SeenBins {");
    replace(text, "look_up(roots.x, shown_world.x, u, v)", "BinValue(vec3(0.5 + next_to_nothing()), vec3(0.01), 0u)");
    replace(text, "look_up(roots.y, shown_world.y, u, v)", "BinValue(vec3(0.2), vec3(0.01), 0u)");
    const std::size_t gloss = text.find("look_up_gloss("), end = text.find(';', gloss);
    text.replace(gloss, end - gloss,
                 "GlossValue(vec3(0.1), vec3(0.02), vec3(0.0), vec3(0.0), vec3(0.01), vec3(0.01), vec3(0.01), 0u)");
    std::ofstream(folder / "chart.glsl") << text;
    return folder.string();
}

/// Milliseconds by the wall clock and of all threads' processor time, which a busy machine spoils less.
struct Frame {
    double wall = 0, processor = 0;
};

double milliseconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Frame frame(Picture& picture) {
    const Frame start{milliseconds(CLOCK_MONOTONIC), milliseconds(CLOCK_PROCESS_CPUTIME_ID)};
    picture.draw();
    picture.finish();
    return {milliseconds(CLOCK_MONOTONIC) - start.wall, milliseconds(CLOCK_PROCESS_CPUTIME_ID) - start.processor};
}

double median(std::vector<Frame> frames, double Frame::*time) {
    std::sort(frames.begin(), frames.end(), [&](const Frame& a, const Frame& b) { return a.*time < b.*time; });
    return frames[frames.size() / 2].*time;
}

void measure(const std::string& name, int frames, const std::string& constants) {
    const auto scene =
        std::make_shared<const Scene>(read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/" + name + ".gltf"));
    Engine engine(scene, {});
    engine.start({1'000'000, {}, {}});
    engine.wait();
    const auto made = [&](const std::string& shaders) {
        set_shader_folder(shaders);
        auto picture = std::make_unique<Picture>(*scene);
        picture->show(engine.snapshot());
        picture->upload();
        picture->look(scene->cameras.front(), 1280, 720);
        frame(*picture);  // compiles
        return picture;
    };
    const auto with = made(""), without = made(constants);
    std::vector<Frame> looked, constant;
    for (int k = 0; k < frames; ++k) {
        looked.push_back(frame(*with));
        constant.push_back(frame(*without));
    }
    std::printf("| %s | %zu |", name.c_str(), engine.snapshot()->leaves.size() / 4);
    for (double Frame::*time : {&Frame::wall, &Frame::processor}) {
        const double a = median(looked, time), b = median(constant, time);
        std::printf(" %.1f | %.1f | %+.1f |", a, b, a - b);
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) try {
    const int frames = count > 1 ? std::max(std::atoi(arguments[1]), 1) : 20;
    const OsmesaContext context;
    const std::string constants = constant_shaders();
    std::printf(
        "| scene | leaves | frame, ms | constants | look-ups | processor: frame | constants | look-ups |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (int k = 2; k < count; ++k) measure(arguments[k], frames, constants);
    return 0;
} catch (const std::exception& failure) {
    std::cerr << failure.what() << "\n";
    return 1;
}
