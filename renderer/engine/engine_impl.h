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

/// One conductor and several workers. The conductor owns the trees: it opens a batch, and the workers take its blocks and
/// trace into tallies of their own. When the batch is done or somebody wants to look, it lets no worker take more, waits
/// until all rest, and takes over what they tallied; then it ends the batch and lets the trees grow, or publishes. What it
/// does meanwhile it shares out among as many threads as rest.
struct Engine::Impl {
    Impl(std::shared_ptr<const Scene> scene_in, const EngineSettings& settings_in);
    ~Impl();

    void conduct();
    void work(unsigned index);
    bool take_block(std::uint64_t& begin, std::uint64_t& end);
    bool rule_holds() const;
    void publish_now(std::unique_lock<std::mutex>& lock);
    void open_batch();
    bool hold(std::unique_lock<std::mutex>& lock);
    bool collect(std::unique_lock<std::mutex>& lock);
    bool end_batch(std::unique_lock<std::mutex>& lock);
    void take_counts();
    void fit_tallies();
    template <int D>
    std::vector<Tally<D>*> tallies(Tally<D> WorkerSums::*tally);
    void count_leaves();
    unsigned threads() const { return static_cast<unsigned>(own.size()); }
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

    // Guarded by the mutex.
    BatchSequence batch;
    std::uint64_t next_photon = 0;  // the first that no worker has taken
    std::uint64_t limit = 0;        // workers take photons below this
    unsigned busy = 0;              // workers inside a block
    WorkerSums sums{bins};          // of the running batch, as far as collected (bins), and of all (ledger, counts)
    std::vector<WorkerSums> own;    // per worker, its own while it is inside a block, the conductor's while it rests
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
