#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "scene/scene.h"

namespace brewster {

/// What a change of a setting costs: new photons, or a new picture from the bins there are.
enum class Change : std::uint8_t { retrace, redraw };

enum class PropertyType : std::uint8_t {
    number,
    bands,      ///< red, green, blue
    direction,  ///< x, y, z of any length but zero
    medium,     ///< a name among named_materials
};

/// number: double; bands, direction: dvec3; medium: its name, empty where it is none of the table's.
using PropertyValue = std::variant<double, glm::dvec3, std::string>;

/// One row of the table of settings: what can be changed while it is looked at. Sliders, --set and tests are made from
/// it. Angles are in degrees here.
template <class Owner>
struct Property {
    std::string_view name;  ///< on the command line
    PropertyType type;
    double least, most;     ///< of each number
    double from, to;        ///< what a slider spans of it
    std::string_view unit;  ///< empty: none
    std::string_view text;  ///< what it is, in a clause
    Change change;
    std::string_view owners;  ///< what it applies to, in words
    bool (*applies)(const Owner&);
    PropertyValue (*get)(const Owner&);
    void (*set)(Owner&, const PropertyValue&);  ///< of the row's type and range, to an owner it applies to
};

std::span<const Property<Material>> material_properties();
std::span<const Property<Lamp>> lamp_properties();

/// The row of that name, or null.
const Property<Material>* find_material_property(std::string_view name);
const Property<Lamp>* find_lamp_property(std::string_view name);

/// Changes a property in a scene that nobody else looks at, with all that follows from it: the lamps that glowing
/// surfaces are, the power of suns. Throws Error where the property does not apply, the value is out of range, or the
/// two together are not simulated.
void set_property(Scene& scene, std::uint32_t material, const Property<Material>& property, const PropertyValue& value);
void set_lamp_property(Scene& scene, std::uint32_t lamp, const Property<Lamp>& property, const PropertyValue& value);

/// "0.3"; "0.2,0.4,0.6" or one number for three bands; "gold". Throws Error for what is no value of this type.
PropertyValue parse_property(PropertyType type, std::string_view text, const std::string& where);
/// The same backwards, in the fewest digits that give the number again.
std::string property_text(const PropertyValue& value);

/// "[0, 0.8]" with its unit: what a person may enter.
std::string range_text(double least, double most, std::string_view unit);

}  // namespace brewster
