// What a draw of the eye costs: bench_gather ROUNDS SCENE...
// CPU nanoseconds of one draw of one pixel on one thread, median of the rounds, for the first camera at 320 x 240 with bins
// of 1e6 photons: whole, then by the tracer's own stages (wall clock inside, so on a busy machine their shares of the
// whole are shown). And what two threads gain: by wall clock, and by their processor time against that of one, which a busy
// machine does not spoil.
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "gather/gather.h"

namespace {

using namespace brewster;

constexpr int width = 320, height = 240;
constexpr std::uint32_t draws_per_pixel = 16;

double cpu_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

std::shared_ptr<const Snapshot> bins_of(const std::shared_ptr<const Scene>& scene) {
    Engine engine(scene, {});
    engine.start({1'000'000, {}, {}});
    engine.wait();
    return engine.snapshot();
}

struct Cost {
    double cpu = 0, wall = 0;  ///< seconds
};

/// Of a picture on so many threads.
Cost picture(const std::shared_ptr<const EyeScene>& scene, const std::shared_ptr<const Snapshot>& bins,
             unsigned threads) {
    Gather gather(scene);
    gather.show(bins);
    gather.look(scene->scene.cameras.front(), width, height);
    const double cpu = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID), wall = cpu_seconds(CLOCK_MONOTONIC);
    gather.draw(draws_per_pixel, threads, [] { return false; });
    return {cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu, cpu_seconds(CLOCK_MONOTONIC) - wall};
}

/// Shares of the tracer's stages.
EyeStageSeconds stages(const EyeScene& scene, const Snapshot& bins) {
    EyeTracer tracer;
    const auto seen = std::make_unique<LevelLight>();
    std::vector<Draw> draws(eye_batch);
    std::uint32_t pixel = 0;
    for (int batch = 0; batch < 300; ++batch) {
        for (Draw& draw : draws) {
            pixel = (pixel + 151) % (width * height);
            draw = {static_cast<std::uint16_t>(pixel % width),
                    static_cast<std::uint16_t>(pixel / width),
                    {sequence_key(1, pixel, 0), static_cast<std::uint32_t>(batch)}};
        }
        tracer.trace(scene, bins, scene.scene.cameras.front(), width, height, draws, *seen);
    }
    EyeStageSeconds seconds = tracer.stage_seconds();
    double sum = 0;
    for (const double stage : seconds) sum += stage;
    for (double& stage : seconds) stage /= sum;
    return seconds;
}

void measure(const std::string& name, int rounds) {
    const auto scene =
        std::make_shared<const Scene>(read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/" + name + ".gltf"));
    const auto bins = bins_of(scene);
    const auto eye_scene = std::make_shared<const EyeScene>(*scene);
    std::vector<double> whole, speedup, gain;
    for (int round = 0; round < rounds; ++round) {
        const Cost one = picture(eye_scene, bins, 1), two = picture(eye_scene, bins, 2);
        whole.push_back(1e9 * one.cpu / (width * height * draws_per_pixel));
        speedup.push_back(one.wall / two.wall);
        gain.push_back(2 * one.cpu / two.cpu);
    }
    const double cost = median(whole);
    std::printf("| %s | %.0f |", name.c_str(), cost);
    for (const double share : stages(*eye_scene, *bins)) std::printf(" %.0f |", share * cost);
    std::printf(" %.2f, %.2f |\n", median(speedup), median(gain));
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) try {
    const int rounds = count > 1 ? std::max(std::atoi(arguments[1]), 1) : 1;
    std::printf(
        "| scene | a draw | hits | bins | lamps | onwards | back | 2 threads over 1 "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (int k = 2; k < count; ++k) measure(arguments[k], rounds);
    return 0;
} catch (const std::exception& failure) {
    std::cerr << failure.what() << "\n";
    return 1;
}
