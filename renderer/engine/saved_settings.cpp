#include "engine/saved_settings.h"

namespace brewster {

ByteWriter settings_block(const SavedSettings& settings) {
    ByteWriter block;
    block.put_text(settings.scene_name);
    block.put_text(settings.scene_hash);
    block.put(static_cast<std::uint64_t>(settings.engine.changes.size()));
    for (const std::string& change : settings.engine.changes) block.put_text(change);
    block.put(settings.photons);
    block.put(settings.seconds);
    const EngineSettings& engine = settings.engine;
    block.put(engine.seed);
    block.put(static_cast<std::uint8_t>(engine.guided_emission));
    block.put(static_cast<std::uint8_t>(engine.kernel.has_value()));
    const KernelChoice kernel = engine.kernel.value_or(KernelChoice{});
    block.put(static_cast<std::int32_t>(kernel.stokes));
    block.put(static_cast<std::int32_t>(kernel.bands));
    block.put(static_cast<std::uint8_t>(kernel.gloss));
    const BinSettings& bins = engine.bins;
    block.put(static_cast<std::uint64_t>(bins.memory_bytes));
    block.put(bins.split_photons);
    block.put(bins.split_z_squared);
    block.put(bins.prune_lambda);
    block.put(static_cast<std::uint8_t>(bins.join_corners));
    block.put(static_cast<std::int32_t>(bins.fixed_grid_log2));
    return block;
}

SavedSettings saved_settings(const SolutionReader& file) {
    ByteReader block = file.block("settings");
    SavedSettings settings;
    settings.scene_name = block.get_text();
    settings.scene_hash = block.get_text();
    for (auto left = block.get<std::uint64_t>(); left > 0; --left) settings.engine.changes.push_back(block.get_text());
    settings.photons = block.get<std::uint64_t>();
    settings.seconds = block.get<double>();
    EngineSettings& engine = settings.engine;
    engine.seed = block.get<std::uint64_t>();
    engine.guided_emission = block.get<std::uint8_t>() != 0;
    const bool forced = block.get<std::uint8_t>() != 0;
    KernelChoice kernel;
    kernel.stokes = block.get<std::int32_t>();
    kernel.bands = block.get<std::int32_t>();
    kernel.gloss = block.get<std::uint8_t>() != 0;
    const bool possible = (kernel.stokes == 1 || kernel.stokes == 3 || kernel.stokes == 4) &&
                          (kernel.bands == 1 || kernel.bands == band_count);
    if (!possible) block.refuse();
    if (forced) engine.kernel = kernel;
    BinSettings& bins = engine.bins;
    bins.memory_bytes = static_cast<std::size_t>(block.get<std::uint64_t>());
    bins.split_photons = block.get<double>();
    bins.split_z_squared = block.get<double>();
    bins.prune_lambda = block.get<double>();
    bins.join_corners = block.get<std::uint8_t>() != 0;
    bins.fixed_grid_log2 = block.get<std::int32_t>();
    if (!block.at_end() || bins.fixed_grid_log2 > 12) block.refuse();
    return settings;
}

}  // namespace brewster
