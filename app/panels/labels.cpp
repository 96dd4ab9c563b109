#include "app/panels/labels.h"

#include <imgui.h>

#include <array>
#include <cctype>
#include <utility>

namespace brewster {

std::string with_unit_signs(std::string text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> signs{
        {{"cd/m2", "cd/m\u00b2"}, {" um", " \u00b5m"}, {" degrees", "\u00b0"}}};
    for (const auto& [plain, sign] : signs)
        for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at + sign.size()))
            text.replace(at, plain.size(), sign);
    return text;
}

std::string setting_label(std::string_view name, std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> signs{
        {{"dolp", "DoLP"}, {"aolp", "AoLP"}, {"docp", "DoCP"}}};
    std::string words;
    for (const char letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        if (std::isupper(code)) words += ' ';
        words += static_cast<char>(std::tolower(code));
    }
    for (const auto& [plain, sign] : signs)
        if (words == plain) words = sign;
    if (unit.empty()) return words;
    return words + (unit == "degrees" ? ", \u00b0" : "," + with_unit_signs(" " + std::string(unit)));
}

std::string map_label(std::string_view title) {
    return std::string(title.substr(0, title.find_first_of(",:")));
}

void faint_text(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

void hint(const char* text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace brewster
