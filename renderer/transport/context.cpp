#include "transport/context.h"

namespace brewster {

void TransportCounts::add(const TransportCounts& other) {
    photons += other.photons;
    useful += other.useful;
    bounces += other.bounces;
    rays += other.rays;
    trouble += other.trouble;
}

Bins::Bins(const std::vector<Outline>& outlines, GlossCharts gloss_charts_in, const EntryFields& entry_in,
           const GlossFields& gloss_in, const BinSettings& settings)
    : entry_fields(entry_in),
      gloss_fields(gloss_in),
      gloss_charts(std::move(gloss_charts_in)),
      entry(outlines, entry_in.layout(), settings),
      gloss(gloss_charts.outlines(outlines), gloss_in.layout(), settings) {}

}  // namespace brewster
