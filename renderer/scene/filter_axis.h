#pragma once
#include "optics/vector.h"
#include "scene/chart.h"
#include "scene/prepared_material.h"
#include "scene/vectors.h"

namespace brewster {

/// The passing axis of a polarizer or the fast axis of a retarder, unit, in the sheet's plane: the same line in space
/// for light from either side. Counter-clockwise from the node's x axis by the filter's angle, seen from the front.
inline Vector<double> filter_axis(const PreparedMaterial& material, const Chart& chart) {
    return material.filter_turn.cosine * vector_of(chart.sheet_x) +
           material.filter_turn.sine * vector_of(chart.sheet_y);
}

}  // namespace brewster
