#pragma once
#include <array>
#include <span>

#include "bins/outline.h"
#include "bins/record.h"

namespace brewster {

/// Sums of one light in one cell over all that landed in it since its birth, its children's included.
struct LightSums {
    std::array<double, band_count> weight{}, squares{};
    std::array<std::array<double, 2>, band_count> moments{};

    bool any() const { return weight[0] > 0 || weight[1] > 0 || weight[2] > 0; }
};

/// Of one field. `own`: the estimate record; `pending`: the leaf's row in the tally of the running batch, or null. Of a
/// tree with one band, all three are that band.
LightSums read_sums(const RecordLayout<2>& layout, std::span<const Wide> own, const Quanta* pending, int field);

/// Adds a child's sums, its cell coordinates turned into the parent's.
void add_child(LightSums& parent, const Box<2>& parent_box, const LightSums& child, const Box<2>& child_box);

}  // namespace brewster
