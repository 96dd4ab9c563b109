#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bins/bin_settings.h"
#include "bins/snapshot.h"
#include "bins/solution_file.h"
#include "scene/needs.h"
#include "scene/scene.h"
#include "transport/kernel.h"
#include "transport/ledger.h"
#include "transport/thesis/thesis_tracer.h"

namespace brewster {

struct EngineSettings {
    std::uint64_t seed = 1;
    unsigned threads = 0;          ///< 0: as many as the machine has
    bool lowest_priority = false;  ///< beside a window: workers yield to it
    /// > 0: publish about this often, less where that would take more than a twentieth of a thread; otherwise only the
    /// first batch and the end.
    double snapshot_seconds = 0;
    BinSettings bins;
    std::size_t window = default_window;  ///< photons that a worker moves at once; 0: one by one, slowly (make_tracer)
    int lanes = widest_lanes();           ///< that it moves together, 8 or 16
    std::vector<std::string> changes;     ///< of the scene since its file was read; only kept with saved solutions
    bool guided_emission = true;          ///< lamps learn where their photons are useful
    std::optional<KernelChoice> kernel;   ///< none: the smallest that is exact for the scene
    ThesisRules thesis;                   ///< habits of the 1997 method, to compare with; never saved
};

/// When to stop; the first that holds. All empty: never.
struct StopRule {
    std::optional<std::uint64_t> photons;
    std::optional<double> seconds;       ///< of tracing, pauses not counted
    std::optional<double> target_error;  ///< area-weighted rms of the relative standard error, where it is lit

    bool operator==(const StopRule&) const = default;
};

/// Numbers for people and reports; all of the same moment.
struct Progress {
    std::uint64_t photons = 0;
    std::vector<std::uint64_t> photons_by_thread;
    std::uint64_t useful_photons = 0;  ///< that deposited at least once
    std::uint64_t bounces = 0;         ///< surface hits
    std::uint64_t rays = 0;
    double seconds = 0;
    double first_snapshot_ms = 0;
    std::uint64_t leaves = 0;            ///< of the tally trees over position
    std::uint64_t gloss_leaves = 0;      ///< of those over position and direction
    std::uint64_t published_leaves = 0;  ///< of the newest snapshot, direct and indirect
    std::uint64_t bytes = 0;             ///< by formula: records and two snapshots
    double relative_error = 0;           ///< of the newest snapshot; 0 until there is one
    std::uint64_t trouble = 0;           ///< numbers that were not finite, rays that went astray
    bool running = false;

    double photons_per_second() const { return seconds > 0 ? static_cast<double>(photons) / seconds : 0; }
};

/// Traces photons of a scene on background threads and files them into bins.
/// A solution is a function of (scene, seed, bin settings, photon count): the number of threads, pauses and the moments
/// of publication do not change a bit of it.
class Engine {
  public:
    /// Throws Error if nothing in the scene emits light, or if `settings.kernel` has one band in a scene of colours.
    Engine(std::shared_ptr<const Scene> scene, const EngineSettings& settings);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Begins, or goes on after a stop, until `rule` holds; counts of the rule are totals since construction.
    void start(const StopRule& rule);
    void pause();  ///< returns when every worker rests; what is traced is published
    void resume();
    void stop();  ///< like pause, and `wait` returns
    void wait();  ///< until the rule holds or stop() is called; throws the Error of a worker that failed
    bool wait_for(double seconds);  ///< true if done, otherwise after `seconds`

    /// Keeps the solution, as it is between runs, in a file that a later engine can go on from.
    /// Throws Error where it cannot be written; what was there stays.
    void save(const std::string& path) const;

    /// Goes on from a saved solution, before the first start; its photons count as traced. Throws Error where the file is
    /// of another scene or other settings (saved_settings), or contradicts itself.
    void load(const SolutionReader& file);

    /// The newest bins, or null before the first. Safe from any thread.
    std::shared_ptr<const Snapshot> snapshot() const;
    Progress progress() const;

    /// Only while no worker runs. The digest is a hash of tree topology and integer sums, as hexadecimal text.
    Ledger ledger() const;
    std::string digest() const;

    const Scene& scene() const;
    const EngineSettings& settings() const;
    const Needs& needs() const;
    const KernelChoice& kernel() const;  ///< what photons carry

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace brewster
