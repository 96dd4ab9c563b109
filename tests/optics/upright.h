#pragma once
#include <cmath>

#include "optics/vector.h"

namespace brewster {

/// The normal of a surface that lies flat.
inline const Vector<double> up{0, 0, 1};

/// Where light comes from that meets it at this cosine, in the plane of x.
inline Vector<double> towards_source(double cos_i) {
    return {std::sqrt((1 - cos_i) * (1 + cos_i)), 0, cos_i};
}

}  // namespace brewster
