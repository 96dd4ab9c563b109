#pragma once
#include <cstdint>
#include <vector>

#include "bins/tree.h"
#include "scene/filter_axis.h"
#include "scene/prepared_material.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "scene/vectors.h"
#include "transport/emission.h"
#include "transport/gloss_charts.h"
#include "transport/ledger.h"

namespace brewster {

/// What photons did, added up over a thread's share.
struct TransportCounts {
    std::uint64_t photons = 0;
    std::uint64_t useful = 0;   ///< photons that deposited at least once
    std::uint64_t bounces = 0;  ///< surfaces hit
    std::uint64_t rays = 0;
    std::uint64_t trouble = 0;  ///< photons given up: a number was not finite

    void add(const TransportCounts& other);
};

/// The trees that photons file into, and what their records hold.
struct Bins {
    /// `outlines`: of all charts of the scene.
    Bins(const std::vector<Outline>& outlines, GlossCharts gloss_charts_in, const EntryFields& entry_in,
         const GlossFields& gloss_in, const BinSettings& settings);

    EntryFields entry_fields;
    GlossFields gloss_fields;
    GlossCharts gloss_charts;
    BinTree<2> entry;  ///< what enters bases, of all charts
    BinTree<4> gloss;  ///< what rough interfaces send on, of gloss_charts in their order
};

/// Everything one worker tallies; on cache lines of its own.
struct alignas(64) WorkerSums {
    explicit WorkerSums(const Bins& bins) : entry(bins.entry.layout()), gloss(bins.gloss.layout()) {}

    /// Makes room for all leaves and cells; a tally that holds sums keeps them.
    void fit(const Bins& bins, const EmissionGuide& emission) {
        entry.resize(bins.entry.leaf_count());
        gloss.resize(bins.gloss.leaf_count());
        guide.resize(emission.cell_count());
    }

    Tally<2> entry;
    Tally<4> gloss;
    GuideTally guide;
    Ledger ledger;
    TransportCounts counts;
};

/// What a kernel needs to know; constant while photons fly.
struct TransportContext {
    const Scene& scene;
    const Rays& rays;
    const PhotonEmission& emission;
    const std::vector<PreparedMaterial>& materials;
    const Bins& bins;
    std::uint64_t seed = 1;
    bool coloured = false;  ///< some base has another albedo from place to place
};

/// Whether light that meets a side of a triangle comes from within a closed transparent body.
inline bool is_inside(const TransportContext& context, std::uint32_t triangle, std::uint32_t chart) {
    const PreparedMaterial& material = context.materials[context.scene.charts[chart].material];
    return material.base == Base::transparent && !material.thin &&
           chart == context.scene.triangles[triangle].back_chart;
}

/// filter_axis of the chart of a filter sheet, zero for all others.
inline Vector<float> filter_axis_of(const TransportContext& context, std::uint32_t chart) {
    const PreparedMaterial& material = context.materials[context.scene.charts[chart].material];
    if (material.filter == FilterKind::none) return {};
    return float_vector(coordinates_of(filter_axis(material, context.scene.charts[chart])));
}

}  // namespace brewster
