#include "app/variant.h"

#include <algorithm>
#include <array>

namespace brewster {
namespace {

struct Variant {
    const char* name;
    bool cells, splits, sampler, absorption;
};

constexpr std::array variants = {
    Variant{"thesis-cells", true, false, false, false},   Variant{"thesis-splits", false, true, false, false},
    Variant{"thesis-sampler", false, false, true, false}, Variant{"thesis-absorption", false, false, false, true},
    Variant{"thesis-all", true, true, true, true},
};

}  // namespace

std::vector<std::string> variant_names() {
    std::vector<std::string> names;
    for (const Variant& variant : variants) names.emplace_back(variant.name);
    return names;
}

bool take_variant(const std::string& name, EngineSettings& settings) {
    const auto* variant =
        std::find_if(variants.begin(), variants.end(), [&](const Variant& v) { return name == v.name; });
    if (variant == variants.end()) return false;
    settings.bins.constant_cells = variant->cells;
    settings.bins.join_corners = !variant->cells;
    settings.bins.half_differences = variant->splits;
    settings.thesis = {variant->sampler, variant->absorption};
    return true;
}

}  // namespace brewster
