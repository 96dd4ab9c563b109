#pragma once

namespace brewster::transport {

/// What a block's time goes into, in the order of a round.
enum class Stage {
    start,       ///< new photons
    meet,        ///< what all rays meet
    sort,        ///< slots by material; the books of photons that end there
    load,        ///< from slots to lanes
    land,        ///< place and normals
    event,       ///< random numbers, the direction of gloss that may be the way on
    enter,       ///< light that enters the base, the way down to its leaf
    file_base,   ///< in the records over position
    lobe,        ///< further directions of gloss, their light
    descend,     ///< the way down to their leaves
    file_gloss,  ///< in the records over position and direction
    scatter,     ///< the way on
    keep,        ///< from lanes to slots
    rest,        ///< what is no part of a block
    count
};

/// Measures nothing and costs nothing. A benchmark puts a clock in its place, whose `enter` ends one stage and begins
/// another.
struct NoClock {
    static void enter(Stage) {}
};

}  // namespace brewster::transport
