#include "scene/properties.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "optics/materials.h"
#include "scene/read_lamp.h"

namespace brewster {
namespace {

template <class Owner>
const Property<Owner>* find(std::span<const Property<Owner>> rows, std::string_view name) {
    for (const Property<Owner>& row : rows)
        if (row.name == name) return &row;
    return nullptr;
}

std::string number_text(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(value)).ptr;
    return {digits.data(), end};
}

template <class Owner>
void set(Owner& owner, const Property<Owner>& property, const PropertyValue& value) {
    const std::string name = std::string(property.name);
    if (!property.applies(owner)) {
        throw Error("it has no " + name, owner.name, "only " + std::string(property.owners) + " have it");
    }
    const auto check = [&](double x) {
        constexpr double rounding = 1e-6;  // values come back from floats
        const double slack = rounding * std::fmax(std::abs(property.least), std::abs(property.most));
        if (x >= property.least - (property.least != 0 ? slack : 0) && x <= property.most + slack) return;
        throw Error("its " + name + " cannot be " + number_text(x), owner.name,
                    "choose " + range_text(property.least, property.most, property.unit));
    };
    if (const auto* one = std::get_if<double>(&value)) check(*one);
    if (const auto* three = std::get_if<glm::dvec3>(&value))
        for (int i = 0; i < 3; ++i) check((*three)[i]);
    property.set(owner, value);
}

std::vector<double> parse_numbers(std::string_view text) {
    std::vector<double> numbers;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view word = text.substr(0, comma);
        double x = 0;
        const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), x);
        if (fault != std::errc() || end != word.data() + word.size() || !std::isfinite(x)) return {};
        numbers.push_back(x);
        if (comma == std::string_view::npos) return numbers;
        text.remove_prefix(comma + 1);
    }
}

std::string media() {
    std::string list;
    for (const OpticalConstants& medium : named_materials)
        list += (list.empty() ? "" : ", ") + std::string(medium.name);
    return list;
}

}  // namespace

const Property<Material>* find_material_property(std::string_view name) {
    return find(material_properties(), name);
}

const Property<Lamp>* find_lamp_property(std::string_view name) {
    return find(lamp_properties(), name);
}

void set_property(Scene& scene, std::uint32_t material, const Property<Material>& property,
                  const PropertyValue& value) {
    set(scene.materials.at(material), property, value);
    renew_area_lamps(scene);
}

void set_lamp_property(Scene& scene, std::uint32_t lamp, const Property<Lamp>& property, const PropertyValue& value) {
    Lamp& changed = scene.lamps.at(lamp);
    set(changed, property, value);
    if (changed.kind == LampKind::sun) changed.power = sun_power(scene, changed);
    if (changed.kind == LampKind::point) changed.power = point_power(changed.intensity);
    if (changed.kind == LampKind::spot)
        changed.power = spot_power(changed.intensity, changed.cos_inner, changed.cos_outer);
}

PropertyValue parse_property(PropertyType type, std::string_view text, const std::string& where) {
    if (type == PropertyType::medium) {
        if (find_medium(text)) return std::string(text);
        throw Error("'" + std::string(text) + "' is no medium known by name", where, "choose " + media());
    }
    const std::vector<double> numbers = parse_numbers(text);
    if (type == PropertyType::number && numbers.size() == 1) return numbers.front();
    if (type == PropertyType::bands && numbers.size() == 1) return glm::dvec3(numbers.front());
    const bool somewhere = numbers.size() == 3 && (numbers[0] != 0 || numbers[1] != 0 || numbers[2] != 0);
    if (type == PropertyType::bands && numbers.size() == 3) return glm::dvec3(numbers[0], numbers[1], numbers[2]);
    if (type == PropertyType::direction && somewhere) return glm::dvec3(numbers[0], numbers[1], numbers[2]);
    throw Error("'" + std::string(text) + "' is not its value", where,
                type == PropertyType::number  ? "give it one number"
                : type == PropertyType::bands ? "give it one number, or red,green,blue"
                                              : "give it x,y,z, not all of them 0");
}

std::string property_text(const PropertyValue& value) {
    if (const auto* one = std::get_if<double>(&value)) return number_text(*one);
    if (const auto* name = std::get_if<std::string>(&value)) return *name;
    const glm::dvec3& three = std::get<glm::dvec3>(value);
    return number_text(three.x) + "," + number_text(three.y) + "," + number_text(three.z);
}

std::string range_text(double least, double most, std::string_view unit) {
    return number_text(least) + " to " + number_text(most) + (unit.empty() ? "" : " " + std::string(unit));
}

}  // namespace brewster
