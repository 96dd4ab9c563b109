#pragma once
#include <array>
#include <span>

#include "bins/outline.h"
#include "bins/record.h"

namespace brewster {

/// Sums of one field in one cell over all that landed in it since its birth, its children's included. Fields of
/// polarization may be negative. Of a tree with one band, all three are that band.
template <int D>
struct FieldSums {
    std::array<double, band_count> weight{}, squares{};
    std::array<std::array<double, D>, band_count> moments{};

    bool any() const { return squares[0] > 0 || squares[1] > 0 || squares[2] > 0; }
};

/// `own`: the estimate record; `pending`: the leaf's row in the tally of the running batch, or null.
template <int D>
FieldSums<D> read_sums(const RecordLayout<D>& layout, std::span<const Wide> own, const Quanta* pending, int field) {
    FieldSums<D> sums;
    for (int band = 0; band < band_count; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const int channel = field * layout.bands + (layout.bands == 1 ? 0 : band);
        const auto row = static_cast<std::size_t>(channel * RecordLayout<D>::estimate_stride);
        const auto value = [&](std::size_t i) { return to_weight(own[row + i] + (pending ? pending[row + i] : 0)); };
        sums.weight[b] = value(0);
        for (std::size_t a = 0; a < D; ++a) sums.moments[b][a] = value(1 + a);
        sums.squares[b] = value(1 + D);
    }
    return sums;
}

/// Adds a child's sums, its cell coordinates turned into the parent's.
template <int D>
void add_child(FieldSums<D>& parent, const Box<D>& parent_box, const FieldSums<D>& child, const Box<D>& child_box) {
    for (std::size_t axis = 0; axis < D; ++axis) {
        const double size = static_cast<double>(parent_box.high[axis] - parent_box.low[axis]);
        const double scale = static_cast<double>(child_box.high[axis] - child_box.low[axis]) / size;
        const double shift = (static_cast<double>(child_box.low[axis]) + static_cast<double>(child_box.high[axis]) -
                              static_cast<double>(parent_box.low[axis]) - static_cast<double>(parent_box.high[axis])) /
                             size;
        for (std::size_t b = 0; b < band_count; ++b)
            parent.moments[b][axis] += scale * child.moments[b][axis] + shift * child.weight[b];
    }
    for (std::size_t b = 0; b < band_count; ++b) {
        parent.weight[b] += child.weight[b];
        parent.squares[b] += child.squares[b];
    }
}

}  // namespace brewster
