#include <time.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/engine.h"

/// Two threads over one where tallies are larger than any cache: `bench_large_tallies ROUNDS LOG2 PHOTONS SCENE...` cuts
/// every chart into 4^LOG2 cells. Seconds by the wall clock and of the processor, and whether all digests are equal;
/// tallies are those of a thread.
namespace brewster {
namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void measure(const std::string& path, int rounds, int log2, std::uint64_t photons) {
    const auto scene = std::make_shared<const Scene>(read_scene(path));
    std::vector<std::string> digests;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    for (int round = 0; round < rounds; ++round) {
        double wall[2]{}, processor[2]{};
        for (const unsigned threads : {1u, 2u}) {
            EngineSettings settings;
            settings.threads = threads;
            settings.bins.fixed_grid_log2 = log2;
            Engine engine(scene, settings);
            StopRule rule;
            rule.photons = photons;
            const double began = seconds_of(CLOCK_MONOTONIC), worked = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
            engine.start(rule);
            engine.wait();
            wall[threads - 1] = seconds_of(CLOCK_MONOTONIC) - began;
            processor[threads - 1] = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - worked;
            digests.push_back(engine.digest());
            if (round > 0 || threads > 1) continue;
            const Progress progress = engine.progress();
            const RecordLayout<2> layout = entry_fields_of(engine.kernel(), engine.needs()).layout();
            const double bytes =
                static_cast<double>(progress.leaves) * (layout.estimate_size() + layout.test_size()) * sizeof(Quanta);
            std::printf("%s: %llu leaves of position, tallies of %.2f GiB a thread\n", scene->name.c_str(),
                        static_cast<unsigned long long>(progress.leaves), bytes / (1 << 30));
        }
        std::printf("  wall %.2f, %.2f s: %.2f times as fast; processor %.2f, %.2f s\n", wall[0], wall[1],
                    wall[0] / wall[1], processor[0], processor[1]);
    }
    bool equal = true;
    for (const std::string& digest : digests) equal = equal && digest == digests.front();
    std::printf("  digests %s\n", equal ? "equal" : "DIFFER");
}

}  // namespace
}  // namespace brewster

int main(int count, char** arguments) {
    if (count < 5) {
        std::fprintf(stderr, "usage: bench_large_tallies ROUNDS LOG2 PHOTONS SCENE...\n");
        return 2;
    }
    for (int i = 4; i < count; ++i)
        brewster::measure(arguments[i], std::stoi(arguments[1]), std::stoi(arguments[2]),
                          static_cast<std::uint64_t>(std::stod(arguments[3])));
}
