#include "engine/engine_impl.h"

#include <algorithm>

#include "base/check.h"
#include "base/digest.h"
#include "base/error.h"
#include "base/priority.h"
#include "base/threads.h"
#include "bins/publish.h"
#include "bins/publish_gloss.h"
#include "bins/tree.h"
#include "engine/outlines.h"

namespace brewster {
namespace {

constexpr double shares_of_publication = 20;  // of the conductor's time, one for publishing: photons need its processor
constexpr std::uint64_t one_part_in_50 = 50;  // batches of a tree that asks its halves as often as it can

KernelChoice chosen_kernel(const Scene& scene, const std::vector<PreparedMaterial>& materials, const Needs& needs,
                           const EngineSettings& settings) {
    const bool gloss = gloss_charts_of(scene, materials).count() > 0;
    if (settings.thesis.any()) return {needs.stokes == 1 ? 1 : 4, 3, gloss};  // make_thesis_tracer knows these
    if (!settings.kernel) return {needs.stokes, needs.bands, gloss};
    if (settings.kernel->bands == 1 && needs.bands == 3)
        throw Error("one band cannot carry its colours", scene.name, "choose a kernel of three bands");
    return *settings.kernel;
}

bool is_coloured(const Scene& scene) {
    return !scene.vertex_colors.empty() || !scene.textures.empty();
}

// From the trees' own numbering of charts to that of the scene.
void spread_roots(GlossBins& gloss, const GlossCharts& charts) {
    std::vector<std::uint32_t> roots(charts.index.size(), no_root);
    for (std::uint32_t i = 0; i < gloss.roots.size(); ++i) roots[charts.charts[i]] = gloss.roots[i];
    gloss.roots = std::move(roots);
}

template <int D>
void add_tree(Digest& digest, const BinTree<D>& tree, const Tally<D>& pending) {
    const auto add_wide = [&](Wide sum) {
        digest.add(static_cast<std::uint64_t>(sum));
        digest.add(static_cast<std::uint64_t>(sum >> 64));
    };
    for (std::uint32_t node = 0; node < tree.node_count(); ++node) {
        digest.add(std::uint64_t{tree.node(node).split} << 32 | tree.node(node).word);
        const CellSums sums = tree.sums(node);
        const bool leaf = tree.node(node).is_leaf() && pending.touched(tree.node(node).leaf());
        const Quanta* estimate = leaf ? pending.estimate(tree.node(node).leaf()) : nullptr;
        const Quanta* test = leaf ? pending.test(tree.node(node).leaf()) : nullptr;
        for (std::size_t i = 0; i < sums.estimate.size(); ++i) add_wide(sums.estimate[i] + (leaf ? estimate[i] : 0));
        for (std::size_t i = 0; i < sums.test.size(); ++i) add_wide(sums.test[i] + (leaf ? test[i] : 0));
    }
}

}  // namespace

Engine::Impl::Impl(std::shared_ptr<const Scene> scene_in, const EngineSettings& settings_in)
    : scene(std::move(scene_in)),
      settings(settings_in),
      rays(*scene),
      emission(*scene, settings.seed),
      materials(prepare_materials(scene->materials)),
      needs(needs_of(*scene)),
      kernel(chosen_kernel(*scene, materials, needs, settings)),
      bins(outlines_of(*scene), gloss_charts_of(*scene, materials), entry_fields_of(kernel, needs),
           GlossFields{kernel.bands, kernel.stokes}, settings.bins),
      context{*scene, rays, emission, materials, bins, settings.seed, is_coloured(*scene)} {
    if (!emission.any()) {
        throw Error("no lamp gives light", scene->name,
                    "add an emissive material or a light of KHR_lights_punctual to the file");
    }
    const unsigned count = thread_count(settings.threads);
    if (settings.bins.half_differences) batch = BatchSequence(1, one_part_in_50);
    for (unsigned index = 0; index < count; ++index) own.emplace_back(bins);
    fit_tallies();
    count_leaves();
    photons_by_thread.assign(count, 0);
    for (unsigned index = 0; index < count; ++index) workers.emplace_back([this, index] { work(index); });
    conductor = std::jthread([this] { conduct(); });
}

Engine::Impl::~Impl() {
    {
        const std::lock_guard lock(mutex);
        quit = true;
        run = false;
    }
    work_to_do.notify_all();
    something_done.notify_all();
}

// With the lock held. False: nothing to take now. Towards the end of a batch, and of small ones, workers take less, so
// that none waits long for another.
bool Engine::Impl::take_block(std::uint64_t& begin, std::uint64_t& end) {
    if (!run || quit || next_photon >= limit) return false;
    begin = next_photon;
    const std::uint64_t share = (limit - begin) / (2 * own.size() * photons_per_block);
    end = std::min(limit, (begin / photons_per_block + std::clamp<std::uint64_t>(share, 1, most_blocks_taken)) *
                              photons_per_block);
    next_photon = end;
    return true;
}

void Engine::Impl::work(unsigned index) {
    if (settings.lowest_priority) lower_priority(Priority::lowest);
    const std::unique_ptr<PhotonTracer> tracer = settings.thesis.any()
                                                     ? make_thesis_tracer(kernel, settings.thesis)
                                                     : make_tracer(kernel, settings.window, settings.lanes);
    std::unique_lock lock(mutex);
    while (!quit) {
        std::uint64_t begin = 0, end = 0;
        if (!take_block(begin, end)) {
            work_to_do.wait(lock);
            continue;
        }
        ++busy;
        lock.unlock();
        try {
            tracer->trace(context, begin, end, own[index]);
        } catch (...) {
            const std::lock_guard failed(mutex);
            if (!failure) failure = std::current_exception();
            run = false;
        }
        lock.lock();
        --busy;
        photons_by_thread[index] += end - begin;
        if (busy == 0) something_done.notify_all();
    }
}

// Lets no worker take photons until the batch is opened again, and waits until all rest. False where the engine ends
// instead.
bool Engine::Impl::hold(std::unique_lock<std::mutex>& lock) {
    limit = next_photon;
    something_done.wait(lock, [&] { return quit || busy == 0; });
    return !quit;
}

// Workers must rest.
void Engine::Impl::take_counts() {
    for (WorkerSums& from : own) {
        sums.counts.add(from.counts);
        sums.ledger.add(from.ledger);
        sums.guide.take(from.guide);
        from.ledger = {};
        from.counts = {};
    }
}

// Workers must rest.
template <int D>
std::vector<Tally<D>*> Engine::Impl::tallies(Tally<D> WorkerSums::*tally) {
    std::vector<Tally<D>*> all;
    for (WorkerSums& from : own) all.push_back(&(from.*tally));
    return all;
}

// Brings all that was tallied together in `sums`. Drops the lock while it computes, so that a window that asks for numbers
// does not wait. False where the engine ends instead.
bool Engine::Impl::collect(std::unique_lock<std::mutex>& lock) {
    if (!hold(lock)) return false;
    take_counts();
    lock.unlock();
    sums.entry.take(tallies(&WorkerSums::entry), threads());
    if (kernel.gloss) sums.gloss.take(tallies(&WorkerSums::gloss), threads());
    lock.lock();
    return !quit;
}

// The trees take in what the batch brought, and grow. Likewise.
bool Engine::Impl::end_batch(std::unique_lock<std::mutex>& lock) {
    if (!hold(lock)) return false;
    take_counts();
    lock.unlock();
    const auto absorb = [&]<int D>(BinTree<D>& tree, Tally<D> WorkerSums::*tally, std::size_t bytes_elsewhere) {
        std::vector<Tally<D>*> all = tallies(tally);
        all.push_back(&(sums.*tally));
        tree.absorb(all, threads());
        tree.split_leaves(batch.end(), settings.bins, bytes_elsewhere, threads());
    };
    absorb(bins.entry, &WorkerSums::entry, bins.gloss.bytes());
    if (kernel.gloss) absorb(bins.gloss, &WorkerSums::gloss, bins.entry.bytes());
    if (settings.guided_emission) emission.guide().learn(sums.guide);
    fit_tallies();
    lock.lock();
    count_leaves();
    batch.next();
    return !quit;
}

void Engine::Impl::fit_tallies() {
    sums.fit(bins, emission.guide());
    for (WorkerSums& worker : own) worker.fit(bins, emission.guide());
}

bool Engine::Impl::rule_holds() const {
    if (failure) return true;
    if (rule.photons && next_photon >= *rule.photons) return true;
    if (rule.seconds && seconds + seconds_since(resumed) >= *rule.seconds) return true;
    return rule.target_error && newest && newest->photons == next_photon && newest->relative_error > 0 &&
           newest->relative_error <= *rule.target_error;
}

// Sums must be collected. Drops the lock while it computes: nobody else changes the trees or the sums.
void Engine::Impl::publish_now(std::unique_lock<std::mutex>& lock) {
    const std::uint64_t photons = sums.counts.photons;
    if (photons == 0 || (newest && newest->photons == photons)) return;
    const bool between_batches = photons == batch.begin();
    lock.unlock();
    auto snapshot =
        std::make_shared<Snapshot>(publish(bins.entry, bins.entry_fields, between_batches ? nullptr : &sums.entry,
                                           photons, flux_per_weight(), settings.bins, threads()));
    if (kernel.gloss) {
        snapshot->gloss = publish_gloss(bins.gloss, bins.gloss_fields, between_batches ? nullptr : &sums.gloss, photons,
                                        flux_per_weight(), settings.bins, threads());
    }
    spread_roots(snapshot->gloss, bins.gloss_charts);
    lock.lock();
    snapshot->version = ++version;
    newest = std::move(snapshot);
    if (version == 1) first_snapshot_ms = 1000 * seconds_since(first_start);
    something_done.notify_all();
}

void Engine::Impl::count_leaves() {
    entry_leaves = bins.entry.leaf_count();
    gloss_leaves = kernel.gloss ? bins.gloss.leaf_count() : 0;
    tree_bytes = bins.entry.bytes() + (kernel.gloss ? bins.gloss.bytes() : 0);
}

glm::dvec3 Engine::Impl::flux_per_weight() const {
    return emission.mean_power() * (kernel.bands == 1 ? glm::dvec3(needs.colour) : glm::dvec3(1.0));
}

void Engine::Impl::open_batch() {
    limit = rule.photons ? std::min(batch.end(), *rule.photons) : batch.end();
    work_to_do.notify_all();
}

void Engine::Impl::conduct() {
    if (settings.lowest_priority) lower_priority(Priority::lowest);
    std::unique_lock lock(mutex);
    auto last_publication = Clock::now();
    double publication_seconds = 0;
    const auto publish_and_clock = [&] {
        const auto begin = Clock::now();
        publish_now(lock);
        last_publication = Clock::now();
        publication_seconds = std::chrono::duration<double>(last_publication - begin).count();
    };
    while (!quit) {
        if (!run) {
            if (!done) {  // paused, stopped or failed: let the blocks in flight end, then show all there is
                if (!collect(lock)) break;
                if (!failure) publish_now(lock);
                seconds += seconds_since(resumed);
                done = true;
                something_done.notify_all();
            }
            work_to_do.wait(lock, [&] { return quit || run || !done; });
            continue;
        }
        open_batch();
        const auto nothing_left = [&] { return next_photon >= limit && busy == 0; };
        // A look now and then: the rule may hold by time, and a window wants pictures.
        something_done.wait_for(lock, std::chrono::milliseconds(5), [&] { return quit || !run || nothing_left(); });
        if (quit || !run) continue;
        const bool wanted = settings.snapshot_seconds > 0 &&
                            seconds_since(last_publication) >=
                                std::max(settings.snapshot_seconds, shares_of_publication * publication_seconds);
        if (next_photon >= batch.end() && busy == 0) {
            if (!end_batch(lock)) break;
            // Until batches have grown to their full length, each makes light much better.
            const bool much_better = !newest || 4 * batch.begin() >= 5 * newest->photons;
            if (!newest || rule.target_error || wanted || (settings.snapshot_seconds > 0 && much_better)) {
                // The next batch may begin meanwhile, unless this picture decides whether it is wanted.
                if (!rule.target_error && !rule_holds()) open_batch();
                publish_and_clock();
            }
        } else if (wanted) {
            if (!collect(lock)) break;
            open_batch();
            publish_and_clock();
        }
        if (rule_holds()) run = false;
    }
}

Engine::Engine(std::shared_ptr<const Scene> scene, const EngineSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(scene), settings)) {}

Engine::~Engine() = default;

void Engine::start(const StopRule& rule) {
    const std::lock_guard lock(impl_->mutex);
    BREWSTER_CHECK(impl_->done, "the engine runs already");
    if (!impl_->started) {
        impl_->started = true;
        impl_->first_start = Clock::now();
    }
    impl_->rule = rule;
    impl_->run = true;
    impl_->done = false;
    impl_->resumed = Clock::now();
    impl_->work_to_do.notify_all();
}

void Engine::load(const SolutionReader& file) {
    std::unique_lock lock(impl_->mutex);
    BREWSTER_CHECK(impl_->done && !impl_->started, "a solution is loaded before the first start");
    impl_->read(file);
    impl_->count_leaves();
    impl_->resumed = Clock::now();
    impl_->done = false;  // the conductor publishes, as after a pause
    impl_->work_to_do.notify_all();
    impl_->something_done.wait(lock, [&] { return impl_->done; });
}

void Engine::save(const std::string& path) const {
    SolutionWriter file;
    {
        const std::lock_guard lock(impl_->mutex);
        BREWSTER_CHECK(impl_->done, "a solution is saved while no photon flies");
        impl_->write(file);
    }
    file.write(path);
}

void Engine::pause() {
    std::unique_lock lock(impl_->mutex);
    impl_->run = false;
    impl_->something_done.notify_all();
    impl_->something_done.wait(lock, [&] { return impl_->done; });
}

void Engine::resume() {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->done) return;
    impl_->run = true;
    impl_->done = false;
    impl_->resumed = Clock::now();
    impl_->work_to_do.notify_all();
}

void Engine::stop() {
    pause();
}

bool Engine::wait_for(double seconds) {
    std::unique_lock lock(impl_->mutex);
    const bool done =
        impl_->something_done.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return impl_->done; });
    if (done && impl_->failure) std::rethrow_exception(impl_->failure);
    return done;
}

void Engine::wait() {
    while (!wait_for(3600)) {
    }
}

std::shared_ptr<const Snapshot> Engine::snapshot() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->newest;
}

Progress Engine::progress() const {
    const std::lock_guard lock(impl_->mutex);
    const Impl& engine = *impl_;
    Progress progress;
    progress.photons = engine.next_photon;
    progress.photons_by_thread = engine.photons_by_thread;
    progress.useful_photons = engine.sums.counts.useful;
    progress.bounces = engine.sums.counts.bounces;
    progress.rays = engine.sums.counts.rays;
    progress.trouble = engine.sums.counts.trouble;
    progress.seconds = engine.seconds + (engine.done ? 0 : seconds_since(engine.resumed));
    progress.first_snapshot_ms = engine.first_snapshot_ms;
    progress.leaves = engine.entry_leaves;
    progress.gloss_leaves = engine.gloss_leaves;
    progress.bytes = engine.tree_bytes;
    progress.running = !engine.done;
    if (engine.newest) {
        progress.relative_error = engine.newest->relative_error;
        progress.published_leaves = engine.newest->leaves.size() / BREWSTER_LEAF_TEXELS;
    }
    return progress;
}

Ledger Engine::ledger() const {
    const std::lock_guard lock(impl_->mutex);
    BREWSTER_CHECK(impl_->done, "the ledger is open while photons fly");
    return impl_->sums.ledger;
}

std::string Engine::digest() const {
    const std::lock_guard lock(impl_->mutex);
    BREWSTER_CHECK(impl_->done, "the sums are open while photons fly");
    Digest digest;
    add_tree(digest, impl_->bins.entry, impl_->sums.entry);
    if (impl_->kernel.gloss) add_tree(digest, impl_->bins.gloss, impl_->sums.gloss);
    return digest.hexadecimal();
}

const Scene& Engine::scene() const {
    return *impl_->scene;
}
const EngineSettings& Engine::settings() const {
    return impl_->settings;
}
const Needs& Engine::needs() const {
    return impl_->needs;
}
const KernelChoice& Engine::kernel() const {
    return impl_->kernel;
}

}  // namespace brewster
