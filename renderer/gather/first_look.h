#pragma once
#include <span>

#include "scene/rays.h"

namespace brewster {

/// The eye's own first rays pass through the backs of single-sided surfaces: goes on with those that ended on one.
inline void look_past_backs(const Rays& rays, std::span<const Ray> from, std::span<Hit> hits) {
    constexpr int most_backs = 256;  // more than that, and it is one surface met again and again by rounding
    for (std::size_t i = 0; i < hits.size(); ++i) {
        Ray ray = from[i];
        for (int back = 0; back < most_backs && !hits[i].escaped() && hits[i].chart == no_chart; ++back) {
            ray.origin = hits[i].position;
            ray.leaving = hits[i].triangle;
            rays.intersect(std::span(&ray, 1), std::span(&hits[i], 1));
        }
    }
}

}  // namespace brewster
