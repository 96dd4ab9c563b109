#include <x86intrin.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "engine/batch.h"
#include "engine/outlines.h"
#include "scene/needs.h"
#include "transport/block/trace_block.h"

/// Nanoseconds a ray that photons in blocks spend in each stage, on one thread: `bench_stages PHOTONS SCENE...`. The
/// processor's clock is read wherever a batch of eight goes from one stage to the next; what reading it costs is taken
/// off. Stages overlap in the processor, so single numbers are good to a few nanoseconds.
namespace brewster::transport {
namespace {

constexpr std::size_t stage_count = static_cast<std::size_t>(Stage::count);
constexpr std::array<const char*, stage_count> names = {
    "starts",     "hits",  "by material", "to lanes",   "landing", "event",    "2-D descent",
    "2-D filing", "lobes", "4-D descent", "4-D filing", "way on",  "to slots", "ends of batches"};

class StageClock {
  public:
    void enter(Stage stage) {
        const std::uint64_t now = __rdtsc();
        ticks_[now_] += now - last_;
        ++entered_[now_];
        now_ = static_cast<std::size_t>(stage);
        last_ = now;
    }
    void reset() { *this = {}; }
    std::uint64_t ticks(std::size_t stage) const { return ticks_[stage]; }
    std::uint64_t entered(std::size_t stage) const { return entered_[stage]; }

  private:
    std::array<std::uint64_t, stage_count> ticks_{}, entered_{};
    std::size_t now_ = static_cast<std::size_t>(Stage::rest);
    std::uint64_t last_ = __rdtsc();
};

double nanoseconds_per_tick() {
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t first = __rdtsc();
    while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(50)) continue;
    const std::uint64_t ticks = __rdtsc() - first;
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() /
           static_cast<double>(ticks);
}

double ticks_of_reading() {
    constexpr int often = 100000;
    StageClock clock;
    for (int i = 0; i < often; ++i) clock.enter(i % 2 == 0 ? Stage::load : Stage::land);
    const auto load = static_cast<std::size_t>(Stage::load), land = static_cast<std::size_t>(Stage::land);
    return static_cast<double>(clock.ticks(load) + clock.ticks(land)) / often;
}

struct Stages {
    std::string scene;
    std::array<double, stage_count> nanoseconds{};  ///< a ray
};

// The engine's sequence of batches on one thread, without publication.
template <int components, int bands, bool gloss>
Stages trace(const Scene& scene, std::uint64_t photons) {
    const std::vector<PreparedMaterial> materials = prepare_materials(scene.materials);
    const Rays rays(scene);
    PhotonEmission emission(scene, 1);
    const BinSettings settings;
    constexpr int worlds = components > 1 ? 2 : 1;
    const EntryFields entry{bands, needs_of(scene).polarized_lamps ? worlds : 1, worlds};
    Bins bins(outlines_of(scene), gloss_charts_of(scene, materials), entry, GlossFields{bands, components}, settings);
    const TransportContext context{scene, rays, emission, materials, bins, 1, false};
    WorkerSums sums(bins);
    BlockTracer<components, bands, gloss, StageClock> tracer(default_window);
    for (BatchSequence batch; batch.begin() < photons; batch.next()) {
        sums.fit(bins, emission.guide());
        tracer.trace(context, batch.begin(), std::min(batch.end(), photons), sums);
        bins.entry.absorb(sums.entry);
        bins.entry.split_leaves(batch.end(), settings, bins.gloss.bytes());
        bins.gloss.absorb(sums.gloss);
        bins.gloss.split_leaves(batch.end(), settings, bins.entry.bytes());
        emission.guide().learn(sums.guide);
    }
    tracer.clock().enter(Stage::rest);
    Stages stages{scene.name, {}};
    const double tick = nanoseconds_per_tick(), reading = ticks_of_reading();
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        const double ticks = static_cast<double>(tracer.clock().ticks(stage)) -
                             reading * static_cast<double>(tracer.clock().entered(stage));
        stages.nanoseconds[stage] = tick * ticks / static_cast<double>(sums.counts.rays);
    }
    return stages;
}

Stages measure(const std::string& path, std::uint64_t photons) {
    const Scene scene = read_scene(path);
    const Needs needs = needs_of(scene);
    if (needs.stokes == 1) return trace<1, 3, false>(scene, photons);
    if (needs.bands == 1) return trace<3, 1, true>(scene, photons);
    return trace<3, 3, true>(scene, photons);
}

}  // namespace
}  // namespace brewster::transport

int main(int count, char** arguments) {
    using namespace brewster::transport;
    if (count < 3) {
        std::fprintf(stderr, "usage: bench_stages PHOTONS SCENE...\n");
        return 2;
    }
    std::vector<Stages> all;
    for (int i = 2; i < count; ++i)
        all.push_back(measure(arguments[i], static_cast<std::uint64_t>(std::stod(arguments[1]))));
    std::printf("%-18s", "nanoseconds a ray");
    for (const Stages& stages : all) std::printf(" %15s", stages.scene.c_str());
    std::printf("\n");
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        std::printf("%-18s", names[stage]);
        for (const Stages& stages : all) std::printf(" %15.1f", stages.nanoseconds[stage]);
        std::printf("\n");
    }
    std::printf("%-18s", "together");
    for (const Stages& stages : all) {
        double sum = 0;
        for (const double part : stages.nanoseconds) sum += part;
        std::printf(" %15.1f", sum);
    }
    std::printf("\n");
}
