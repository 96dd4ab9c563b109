#include "app/suggestion.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace brewster {
namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Optimal string alignment: insertions, deletions, substitutions, swaps of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    const std::size_t columns = b.size() + 1;
    std::vector<std::size_t> distance((a.size() + 1) * columns);
    const auto at = [&](std::size_t row, std::size_t column) -> std::size_t& {
        return distance[row * columns + column];
    };
    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = at(i - 1, j - 1) + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, changed});
            if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1])) {
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
            }
        }
    }
    return distance.back();
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view mistyped, std::span<const std::string> known) {
    std::optional<std::string> nearest;
    std::size_t least = std::max<std::size_t>(1, mistyped.size() / 3) + 1;
    for (const std::string& name : known) {
        const std::size_t distance = edit_distance(mistyped, name);
        if (distance < least) {
            least = distance;
            nearest = name;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view mistyped, std::span<const std::string> known) {
    const std::optional<std::string> nearest = nearest_name(mistyped, known);
    return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace brewster
