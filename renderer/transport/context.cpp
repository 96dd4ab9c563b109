#include "transport/context.h"

namespace brewster {
namespace {

std::vector<Outline> selected(const std::vector<Outline>& outlines, const std::vector<std::uint32_t>& charts) {
    std::vector<Outline> chosen;
    for (const std::uint32_t chart : charts) chosen.push_back(outlines[chart]);
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
      gloss(selected(outlines, gloss_charts.charts), gloss_in.layout(), settings) {}

}  // namespace brewster
