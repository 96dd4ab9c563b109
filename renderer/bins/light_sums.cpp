#include "bins/light_sums.h"

namespace brewster {

LightSums read_sums(const RecordLayout<2>& layout, std::span<const Wide> own, const Quanta* pending, int field) {
    LightSums sums;
    for (int band = 0; band < band_count; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const int channel = field * layout.bands + (layout.bands == 1 ? 0 : band);
        const auto row = static_cast<std::size_t>(channel * RecordLayout<2>::estimate_stride);
        const auto value = [&](std::size_t i) { return to_weight(own[row + i] + (pending ? pending[row + i] : 0)); };
        sums.weight[b] = value(0);
        sums.moments[b] = {value(1), value(2)};
        sums.squares[b] = value(3);
    }
    return sums;
}

void add_child(LightSums& parent, const Box<2>& parent_box, const LightSums& child, const Box<2>& child_box) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
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
