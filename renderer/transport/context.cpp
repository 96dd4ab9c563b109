#include "transport/context.h"

namespace brewster {
namespace {

std::vector<Outline> selected(const std::vector<Outline>& outlines, const GlossCharts& gloss) {
    std::vector<Outline> chosen;
    for (std::uint32_t i = 0; i < gloss.count(); ++i) {
        chosen.push_back(outlines[gloss.charts[i]]);
        if (gloss.coarse[i]) chosen.back().least_cell = coarse_cell;
    }
    return chosen;
}

}  // namespace

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
      gloss(selected(outlines, gloss_charts), gloss_in.layout(), settings) {}

}  // namespace brewster
