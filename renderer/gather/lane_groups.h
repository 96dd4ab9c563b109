#pragma once
#include "gather/eye_level.h"
#include "gather/eye_numbers.h"

namespace brewster {

/// Calls shade<FloatLanes>(i) for each eight entries of a group, shade<float>(i) for the rest: the same bits.
template <class Shade>
void over(const Group& group, const Shade& shade) {
    std::uint32_t i = group.first;
    for (; i + lane_count <= group.end; i += lane_count) shade.template operator()<FloatLanes>(i);
    for (; i < group.end; ++i) shade.template operator()<float>(i);
}

/// Whose numbers the draws of a batch take.
struct BatchNumbers {
    std::array<std::uint32_t, eye_batch> keys, indices;

    /// A pair for each entry of a group.
    void draw(const Level& level, const Group& group, std::uint32_t dimension, std::array<float, most_rays>& first,
              std::array<float, most_rays>& second) const {
        over(group, [&]<class Real>(std::uint32_t i) {
            const Word<Real> of = load_word<Real>(&level.draw[i]);
            const auto pair = number_pair<Real>(entries_of(keys.data(), of), entries_of(indices.data(), of), dimension);
            store(pair[0], &first[i]);
            store(pair[1], &second[i]);
        });
    }
};

}  // namespace brewster
