#pragma once
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/batch.h"
#include "engine/engine.h"
#include "scene/rays.h"
#include "transport/emission.h"
#include "transport/kernel.h"

/// What the engine's own files share.
namespace brewster {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// One conductor and several workers. The conductor owns the trees: it opens a batch, the workers take its blocks and
/// trace into tallies of their own, and hand them over when the batch is done or somebody wants to look; then the
/// conductor publishes, or ends the batch and lets the trees grow. Nobody reads another thread's tallies.
struct Engine::Impl {
    Impl(std::shared_ptr<const Scene> scene_in, const EngineSettings& settings_in);
    ~Impl();

    void conduct();
    void work(unsigned index);
    bool take_block(std::uint64_t& begin, std::uint64_t& end);
    bool rule_holds() const;
    void publish_now(std::unique_lock<std::mutex>& lock);
    void open_batch();
    bool collect(std::unique_lock<std::mutex>& lock);
    void count_leaves();
    glm::dvec3 flux_per_weight() const;
    void write(SolutionWriter& file) const;
    void read(const SolutionReader& file);

    const std::shared_ptr<const Scene> scene;
    const EngineSettings settings;
    const Rays rays;
    PhotonEmission emission;
    const std::vector<PreparedMaterial> materials;
    const Needs needs;
    const KernelChoice kernel;
    Bins bins;
    const TransportContext context;

    mutable std::mutex mutex;
    std::condition_variable work_to_do, something_done;
    std::mutex merge;  // of tallies into the sums of the batch; taken last

    // Guarded by the mutex.
    BatchSequence batch;
    std::uint64_t next_photon = 0;           // the first that no worker has taken
    std::uint64_t limit = 0;                 // workers take photons below this
    unsigned busy = 0;                       // workers inside a block
    std::uint64_t hand_over = 0;             // a growing wish: hand over what you have
    std::vector<std::uint64_t> handed_over;  // per worker: the wish it has met
    WorkerSums sums{bins};                   // of the running batch (bins; by `merge`) and of all (ledger, counts)
    std::vector<std::uint64_t> photons_by_thread;
    StopRule rule;
    bool run = false;  // the user wants photons
    bool done = true;  // nothing left to do for this start
    bool quit = false;
    double seconds = 0;  // of tracing, before the present run
    Clock::time_point resumed;
    double first_snapshot_ms = 0;
    Clock::time_point first_start;
    bool started = false;
    std::exception_ptr failure;
    std::shared_ptr<const Snapshot> newest;
    std::uint64_t version = 0;
    std::size_t entry_leaves = 0, gloss_leaves = 0, tree_bytes = 0;

    std::vector<std::jthread> workers;
    std::jthread conductor;
};

}  // namespace brewster
