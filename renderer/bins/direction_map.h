#pragma once
#include <cmath>
#include <glm/vec2.hpp>

#include "base/lanes.h"

/// The C++ side of the map of directions; the formula stands in shaders/shared/direction_map.h.
namespace brewster::direction_map {

using glm::vec2;
using std::abs, std::sqrt;

inline float min(float a, float b) {
    return b < a ? b : a;
}

#define BREWSTER_FUNCTION inline
#include "shared/direction_map.h"
#undef BREWSTER_FUNCTION

/// A point of the square of directions.
template <class Real>
struct SquarePoint {
    Real x, y;
};

/// direction_square without branches, for lanes and for one: the same bits as the formula's.
template <class Real>
SquarePoint<Real> direction_square_of(const Real& x, const Real& y) {
    const Real radius = brewster::min(brewster::sqrt(x * x + y * y), Real(1));
    const auto wide = brewster::abs(x) >= brewster::abs(y);
    const Real longer = select(wide, x, y), shorter = select(wide, y, x);
    const auto somewhere = radius > 0;
    const Real ratio = shorter / select(somewhere, longer, Real(1));
    const Real r2 = ratio * ratio;
    Real p = constant<Real>(0.0028662257f);
    for (const float c :
         {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f, -0.1420889944f, 0.1999355085f, -0.3333314528f})
        p = p * r2 + Real(c);
    const Real angle = ratio + ratio * r2 * p;
    const Real along = select(longer < 0, -radius, radius);
    const Real across = along * constant<Real>(1.2732395447351628f) * angle;
    const Real half = constant<Real>(0.5);
    const Real on_x = half + half * select(wide, along, across), on_y = half + half * select(wide, across, along);
    return {select(somewhere, on_x, half), select(somewhere, on_y, half)};
}

}  // namespace brewster::direction_map
