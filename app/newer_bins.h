#pragma once
#include <cstdint>

namespace brewster {

/// New bins begin a new mean. Until it has so many draws the old picture stays, so that edges do not flicker, and no
/// newer bins are taken, so that it gets there however slow the drawing is.
inline constexpr int draws_before_change = 8;

/// Bins of so many times the photons are so much better that what is drawn of the old ones need not be finished.
inline constexpr std::uint64_t far_better = 4;

/// What newer bins of the same scene, at rest, do to those that are drawn: nothing yet, or take their place once they
/// have been drawn so often, or with their first draw.
enum class Newer { wait, after_draws, at_once };

/// `drawn` and `newest`: their photons; `draws`: of those that are drawn. Slow drawing must not keep the first bins on
/// the screen while others far better are there.
inline Newer newer_bins(std::uint64_t drawn, std::uint64_t newest, int draws) {
    if (draws > 0 && newest >= far_better * drawn) return Newer::at_once;
    return draws >= draws_before_change ? Newer::after_draws : Newer::wait;
}

}  // namespace brewster
