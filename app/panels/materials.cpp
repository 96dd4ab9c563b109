#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/clock.h"
#include "app/material_summary.h"
#include "app/numbers.h"
#include "app/panels/desk.h"
#include "app/panels/labels.h"
#include "app/scene_summary.h"
#include "base/error.h"
#include "optics/materials.h"
#include "scene/properties.h"

namespace brewster {
namespace {

/// A number with so few digits that it fits, and enough to be read.
constexpr const char* number_format = "%.4g";

/// A change that a widget asks for.
template <class Owner>
struct Wish {
    const Property<Owner>* property = nullptr;
    PropertyValue value;
    bool new_step = false;
};

/// What undo takes back as one begins when a widget is taken hold of.
bool taken_hold() {
    return ImGui::IsItemActivated();
}

/// A slider, or for what has no end a number that grows by dragging. True while it changes.
bool number_widget(const char* label, double& value, double from, double to, double least, double most) {
    auto shown = static_cast<float>(value);
    bool changed = false;
    if (most > 1e3 && to >= 1e5) {
        const float speed = std::max(1e-3f, 0.01f * std::abs(shown));
        changed =
            ImGui::DragFloat(label, &shown, speed, static_cast<float>(least), static_cast<float>(most), number_format);
    } else {
        changed = ImGui::SliderFloat(label, &shown, static_cast<float>(from), static_cast<float>(to), number_format);
    }
    value = std::clamp(static_cast<double>(shown), least, most);
    return changed;
}

std::string medium_words(const OpticalConstants& medium) {
    return std::string(medium.name) + ", n " + significant(medium.n[1]) +
           (medium.k[1] > 0 ? ", k " + significant(medium.k[1]) : "");
}

bool medium_widget(std::string& name) {
    bool changed = false;
    const OpticalConstants* chosen = find_medium(name);
    if (!ImGui::BeginCombo("medium", chosen ? medium_words(*chosen).c_str() : "by numbers")) return false;
    for (const OpticalConstants& medium : named_materials) {
        if (ImGui::Selectable(medium_words(medium).c_str(), &medium == chosen)) {
            name = medium.name;
            changed = true;
        }
        hint(std::string(medium.source).c_str());
    }
    ImGui::EndCombo();
    return changed;
}

/// One row of the table as a widget; the wish to change it, if there is one.
template <class Owner>
void property_widget(const Owner& owner, const Property<Owner>& row, bool& step, Wish<Owner>& wish) {
    const std::string label = setting_label(row.name, row.unit);
    PropertyValue value = row.get(owner);
    bool changed = false;
    ImGui::PushID(label.c_str());
    switch (row.type) {
        case PropertyType::number: {
            double number = std::get<double>(value);
            changed = number_widget(label.c_str(), number, row.from, row.to, row.least, row.most);
            step = step || taken_hold();
            value = number;
            break;
        }
        case PropertyType::bands: {
            glm::dvec3 bands = std::get<glm::dvec3>(value);
            if (row.least >= 0 && row.most <= 1) {
                glm::vec3 colour(bands);
                changed = ImGui::ColorEdit3(label.c_str(), &colour.x, ImGuiColorEditFlags_Float);
                step = step || taken_hold();
                bands = glm::clamp(glm::dvec3(colour), 0.0, 1.0);
            } else if (bands.x == bands.y && bands.y == bands.z) {
                changed = number_widget(label.c_str(), bands.x, row.from, row.to, row.least, row.most);
                step = step || taken_hold();
                bands = glm::dvec3(bands.x);
            } else {
                glm::vec3 shown(bands);
                const float speed = std::max(1e-3f, 0.01f * std::abs(shown.x));
                changed = ImGui::DragFloat3(label.c_str(), &shown.x, speed, static_cast<float>(row.least),
                                            static_cast<float>(row.most), number_format);
                step = step || taken_hold();
                bands = glm::clamp(glm::dvec3(shown), row.least, row.most);
            }
            value = bands;
            break;
        }
        case PropertyType::medium: {
            std::string name = std::get<std::string>(value);
            changed = medium_widget(name);
            step = step || changed;
            value = name;
            break;
        }
        case PropertyType::direction:
            break;  // elevation and azimuth say the same
    }
    std::string words(row.text);
    if (row.type != PropertyType::medium)
        words += "\n" + with_unit_signs(range_text(row.least, row.most, row.unit)) + "; Ctrl+click to type";
    hint(words.c_str());
    ImGui::PopID();
    if (changed) wish = {&row, value, step};
}

template <class Owner, class Set>
void property_rows(Desk& desk, const Owner& owner, std::span<const Property<Owner>> rows, const Set& set) {
    static bool step = false;  // a widget was taken hold of, and the scene has not changed since
    Wish<Owner> wish;
    ImGui::PushItemWidth(0.52f * ImGui::GetContentRegionAvail().x);
    for (const Property<Owner>& row : rows) {
        if (row.type == PropertyType::direction || row.name == "m" || !row.applies(owner)) continue;
        property_widget(owner, row, step, wish);
    }
    ImGui::PopItemWidth();
    if (!wish.property) return;
    auto changed = std::make_shared<Scene>(desk.scene);
    try {
        // By way of text, so that a saved solution and --set give the same scene to the last bit.
        const Setting setting{owner.name, std::string(wish.property->name), property_text(wish.value)};
        set(*changed, *wish.property, parse_property(wish.property->type, setting.value, owner.name));
        desk.change_scene(std::move(changed), setting, step);
        step = false;
    } catch (const Error& error) {
        desk.shown.notice = error.what();
        desk.shown.notice_until = seconds_now() + 4;
    }
}

ImVec4 chip(const Material& material) {
    const glm::vec3 colour =
        material.emits()
            ? material.emission / std::max({material.emission.x, material.emission.y, material.emission.z, 1e-6f})
        : material.interface.kind == InterfaceKind::conductor ? normal_reflectance(material.interface)
                                                              : material.albedo;
    const auto code = [](float x) { return std::pow(x, 1 / 2.2f); };
    return {code(colour.x), code(colour.y), code(colour.z), 1};
}

void one_material(Desk& desk, std::uint32_t index) {
    const Material& material = desk.scene.materials[index];
    const auto [yes, why] = polarizes(material);
    ImGui::TextWrapped("%s", with_unit_signs(described(desk.scene, material)).c_str());
    ImGui::TextWrapped("polarizes: %s, because %s", yes ? "yes" : "no", why.c_str());
    if (const auto angle = brewster_angle(material)) ImGui::Text("Brewster's angle %.2f\u00b0", *angle);
    property_rows<Material>(desk, material, material_properties(),
                            [&](Scene& scene, const Property<Material>& row, const PropertyValue& value) {
                                set_property(scene, index, row, value);
                            });
}

}  // namespace

void materials_panel(Desk& desk) {
    Shown& shown = desk.shown;
    const auto count = static_cast<int>(desk.scene.materials.size());
    if (shown.material >= count) shown.material = -1;
    faint_text("click one, or M over the picture");
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float frame = 2 * ImGui::GetStyle().WindowPadding.y - ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("materials", {0, line * static_cast<float>(std::clamp(count, 3, 7)) + frame}, true);
    for (int i = 0; i < count; ++i) {
        const Material& material = desk.scene.materials[static_cast<std::size_t>(i)];
        ImGui::PushID(i);
        ImGui::ColorButton("##chip", chip(material), ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {ImGui::GetTextLineHeight(), ImGui::GetTextLineHeight()});
        ImGui::SameLine();
        if (ImGui::Selectable(material.name.c_str(), shown.material == i)) {
            shown.material = i;
            shown.lamp = -1;
        }
        if (shown.scroll_to_material && shown.material == i) ImGui::SetScrollHereY();
        ImGui::PopID();
    }
    ImGui::EndChild();
    for (std::size_t i = 0; i < desk.scene.lamps.size(); ++i) {
        const Lamp& lamp = desk.scene.lamps[i];
        if (lamp.kind == LampKind::area) continue;
        const std::string label = lamp.name + " (" + std::string(lamp_kind_name(lamp.kind)) + ")";
        if (ImGui::Selectable(label.c_str(), shown.lamp == static_cast<int>(i))) {
            shown.lamp = static_cast<int>(i);
            shown.material = -1;
        }
    }
    if (ImGui::Button("undo (Ctrl+Z)") && desk.session.can_undo()) desk.act(Action::undo, 0);
    ImGui::SameLine();
    if (ImGui::Button("redo (Ctrl+Y)") && desk.session.can_redo()) desk.act(Action::redo, 0);
    ImGui::Separator();
    if (shown.material >= 0) {
        one_material(desk, static_cast<std::uint32_t>(shown.material));
        // What a person wants to drag next is to be in sight.
        const float below = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
        if (shown.scroll_to_material && ImGui::GetCursorScreenPos().y > below) ImGui::SetScrollHereY(1.0f);
        shown.scroll_to_material = false;
    }
    if (shown.lamp >= 0 && shown.lamp < static_cast<int>(desk.scene.lamps.size())) {
        const auto index = static_cast<std::uint32_t>(shown.lamp);
        property_rows<Lamp>(desk, desk.scene.lamps[index], lamp_properties(),
                            [&](Scene& scene, const Property<Lamp>& row, const PropertyValue& value) {
                                set_lamp_property(scene, index, row, value);
                            });
    }
}

}  // namespace brewster
