#include "bins/tally.h"

#include <algorithm>

#include "base/threads.h"

namespace brewster {

template <int D>
void Tally<D>::take(std::span<Tally* const> others, unsigned threads) {
    constexpr std::size_t leaves_at_a_time = 512;
    // Into an empty tally the first moves as a whole: no number is copied, no page asked for.
    if (std::find(touched_.begin(), touched_.end(), 1) == touched_.end()) std::swap(*this, *others.front());
    over_ranges(leaves(), leaves_at_a_time, threads, [&](std::size_t begin, std::size_t end) {
        for (auto leaf = static_cast<std::uint32_t>(begin); leaf < end; ++leaf)
            for (Tally* const other : others) {
                if (!other->touched(leaf)) continue;
                const Rows rows = touch(leaf);
                other->move(leaf, rows.estimate, rows.test);
            }
    });
}

template class Tally<2>;
template class Tally<4>;

}  // namespace brewster
