#pragma once
#include <type_traits>

#include "optics/vector.h"

namespace brewster {

/// A unit axis orthogonal to the direction, by its cross product with `other`; any where they are parallel.
template <class Real>
Vector<Real> axis_across(const Vector<Real>& direction, const Vector<Real>& other) {
    const Vector<Real> across = cross(direction, other);
    const Real length2 = dot(across, across);
    // Branchless basis of Duff et al. 2017 for what has no plane.
    const Real sign = select(direction.z < 0, Real(-1), Real(1));
    const Real a = -1 / (sign + direction.z);
    const Vector<Real> any{1 + sign * direction.x * direction.x * a, sign * direction.x * direction.y * a,
                           -sign * direction.x};
    const auto oblique = length2 > constant<Real>(std::is_same_v<Real, double> ? 1e-24 : 1e-12);
    return select(oblique, unit_again((1 / sqrt(select(oblique, length2, Real(1)))) * across), any);
}

}  // namespace brewster
