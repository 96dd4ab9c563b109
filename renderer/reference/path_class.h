#pragma once

namespace brewster {

/// Paths from a lamp to the camera, told apart by the lobes at their surfaces: *base* (Lambert, polarized diffuse),
/// *gloss*, *sharp* (mirror, refraction) and *straight* (through a pane or filter), the latter three being events of an
/// interface. Disjoint and complete. Sheets that are crossed straight on next to the camera belong to its look and do
/// not count.
/// The camera tracer cannot find `sharply_lit`, the light tracer neither `seen` nor `mirrored`; both can do the others.
enum class PathClass : unsigned {
    seen = 1,          ///< no surface between lamp and camera
    bases = 2,         ///< base events only
    reflections = 4,   ///< events of interfaces, none of them lampward of a base
    caustics = 8,      ///< an event of an interface lampward of a base
    sharply_lit = 16,  ///< no caustic, but sharp next to a lamp without extent
    mirrored = 32,     ///< whatever comes next, the vertex next to the camera is sharp
};

/// A set of classes.
using PathClasses = unsigned;

constexpr bool contains(PathClasses classes, PathClass one) {
    return (classes & static_cast<unsigned>(one)) != 0;
}
constexpr PathClasses operator|(PathClass a, PathClass b) {
    return static_cast<unsigned>(a) | static_cast<unsigned>(b);
}
constexpr PathClasses operator|(PathClasses a, PathClass b) {
    return a | static_cast<unsigned>(b);
}

/// Who renders what: a camera tracer hardly ever finds the lamp behind a base and an interface.
inline constexpr PathClasses camera_tracer_owns =
    PathClass::seen | PathClass::bases | PathClass::reflections | PathClass::mirrored;
inline constexpr PathClasses light_tracer_owns = PathClass::caustics | PathClass::sharply_lit;

enum class Event { base, gloss, sharp, straight };

/// The class of a path that grows from the camera.
class EyePathClass {
  public:
    void add(Event event) {
        if (!any_ && event == Event::straight) return;
        if (!any_) mirrored_ = event == Event::sharp;
        any_ = true;
        if (event == Event::base) {
            base_ = true;
        } else {
            interface_ = true;
            caustic_ = caustic_ || base_;
        }
    }
    PathClass with(Event event) const {
        EyePathClass longer = *this;
        longer.add(event);
        return longer.value();
    }
    PathClass value() const {
        if (!any_) return PathClass::seen;
        if (mirrored_) return PathClass::mirrored;
        if (caustic_) return PathClass::caustics;
        return interface_ ? PathClass::reflections : PathClass::bases;
    }
    /// False once no path that goes on from here can be in the set.
    bool can_end_in(PathClasses classes) const {
        if (!any_) return classes != 0;
        if (mirrored_) return contains(classes, PathClass::mirrored);
        if (contains(classes, PathClass::caustics)) return true;
        if (caustic_) return false;
        if (contains(classes, PathClass::reflections) && (interface_ || !base_)) return true;
        return contains(classes, PathClass::bases) && !interface_;
    }

  private:
    bool any_ = false, mirrored_ = false, base_ = false, interface_ = false, caustic_ = false;
};

/// The class of a path that grows from a lamp and ends at a vertex seen by the camera, which is never sharp.
class LightPathClass {
  public:
    explicit LightPathClass(bool lamp_without_extent) : point_like_(lamp_without_extent) {}

    void add(Event event) {
        if (!any_) sharply_lit_ = point_like_ && (event == Event::sharp || event == Event::straight);
        any_ = true;
        if (event == Event::base)
            caustic_ = caustic_ || interface_;
        else
            interface_ = true;
    }
    PathClass with(Event event) const {
        LightPathClass longer = *this;
        longer.add(event);
        if (longer.caustic_) return PathClass::caustics;
        if (longer.sharply_lit_) return PathClass::sharply_lit;
        return longer.interface_ ? PathClass::reflections : PathClass::bases;
    }

  private:
    bool point_like_, any_ = false, interface_ = false, caustic_ = false, sharply_lit_ = false;
};

}  // namespace brewster
