#include <bit>

#include "base/error.h"
#include "engine/engine_impl.h"
#include "engine/outlines.h"
#include "engine/saved_settings.h"
#include "scene/scene_hash.h"

// A solution as a file: everything that the next photon's result depends on.
namespace brewster {
namespace {

void write_account(ByteWriter& block, const Ledger::Account& account) {
    for (const auto& world : account)
        for (const Wide sum : world) block.put(sum);
}
void read_account(ByteReader& block, Ledger::Account& account) {
    for (auto& world : account)
        for (Wide& sum : world) sum = block.get<Wide>();
}

constexpr Ledger::Account Ledger::*accounts[] = {&Ledger::emitted,  &Ledger::absorbed, &Ledger::escaped, &Ledger::cut,
                                                 &Ledger::roulette, &Ledger::shading,  &Ledger::capped};
constexpr std::uint64_t TransportCounts::*counts[] = {&TransportCounts::photons, &TransportCounts::useful,
                                                      &TransportCounts::bounces, &TransportCounts::rays,
                                                      &TransportCounts::trouble};

bool equal_bins(const BinSettings& a, const BinSettings& b) {
    return a.memory_bytes == b.memory_bytes && a.split_photons == b.split_photons &&
           a.split_z_squared == b.split_z_squared && a.prune_lambda == b.prune_lambda &&
           a.join_corners == b.join_corners && a.fixed_grid_log2 == b.fixed_grid_log2;
}

}  // namespace

void Engine::Impl::write(SolutionWriter& file) const {
    SavedSettings saved;
    saved.scene_name = scene->name;
    saved.scene_hash = scene_hash(*scene);
    saved.photons = sums.counts.photons;
    saved.seconds = seconds;
    saved.engine = settings;
    file.add("settings", settings_block(saved));

    ByteWriter books;
    for (const auto count : counts) books.put(sums.counts.*count);
    for (const auto account : accounts) write_account(books, sums.ledger.*account);
    books.put(batch.begin());
    file.add("books", books);

    ByteWriter entry, gloss, guide;
    bins.entry.write(entry);
    sums.entry.write(entry);
    file.add("entry", entry);
    bins.gloss.write(gloss);
    sums.gloss.write(gloss);
    file.add("gloss", gloss);
    guide.put(static_cast<std::uint64_t>(emission.guide().cell_count()));
    for (const EmissionGuide::Node& node : emission.guide().nodes()) {
        guide.put(node.low_child);
        guide.put(node.traced);
        guide.put(node.useful);
    }
    guide.put_all(sums.guide.traced);
    guide.put_all(sums.guide.useful);
    file.add("guide", guide);
}

void Engine::Impl::read(const SolutionReader& file) {
    const SavedSettings saved = saved_settings(file);
    if (saved.scene_hash != scene_hash(*scene))
        throw Error("it was traced in another scene, called \"" + saved.scene_name + "\"", file.path(),
                    "name the scene file that it was made of, unchanged");
    if (saved.engine.seed != settings.seed || saved.engine.guided_emission != settings.guided_emission ||
        saved.engine.kernel != settings.kernel || !equal_bins(saved.engine.bins, settings.bins))
        throw Error("it was traced with other settings", file.path(), "take those that it holds");

    ByteReader books = file.block("books");
    for (const auto count : counts) sums.counts.*count = books.get<std::uint64_t>();
    for (const auto account : accounts) read_account(books, sums.ledger.*account);
    const auto running = BatchSequence::beginning_at(books.get<std::uint64_t>());
    if (!running || !books.at_end() || sums.counts.photons != saved.photons || running->end() < saved.photons ||
        running->begin() > saved.photons)
        books.refuse();
    batch = *running;
    next_photon = saved.photons;
    seconds = saved.seconds;

    const std::vector<Outline> outlines = outlines_of(*scene);
    ByteReader entry = file.block("entry"), gloss = file.block("gloss"), guide = file.block("guide");
    bins.entry = BinTree<2>::read(entry, outlines, bins.entry.layout());
    bins.gloss = BinTree<4>::read(gloss, bins.gloss_charts.outlines(outlines), bins.gloss.layout());
    std::vector<EmissionGuide::Node> nodes;
    for (auto left = guide.get<std::uint64_t>(); left > 0; --left) {
        EmissionGuide::Node node;
        node.low_child = guide.get<std::uint32_t>();
        node.traced = guide.get<std::uint64_t>();
        node.useful = guide.get<std::uint64_t>();
        nodes.push_back(node);
    }
    if (!emission.guide().restore(std::move(nodes))) guide.refuse();
    sums.guide.traced = guide.get_all<std::uint64_t>();
    sums.guide.useful = guide.get_all<std::uint64_t>();
    const std::size_t cells = emission.guide().cell_count();
    if (sums.guide.traced.size() != cells || sums.guide.useful.size() != cells) guide.refuse();
    fit_tallies();
    sums.entry.read(entry);
    sums.gloss.read(gloss);
    if (!entry.at_end() || !gloss.at_end() || !guide.at_end()) entry.refuse();
}

}  // namespace brewster
