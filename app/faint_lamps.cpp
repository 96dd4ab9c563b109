#include "app/faint_lamps.h"

#include <map>

namespace brewster {

std::vector<std::string> faint_lamps(const Scene& scene, double photons) {
    constexpr double least_photons = 10;
    std::map<std::string, double> powers;  // a glowing mesh is many lamps of one name
    double total = 0;
    for (const Lamp& lamp : scene.lamps) {
        const double power = static_cast<double>(lamp.mean_power());
        powers[lamp.name] += power;
        total += power;
    }
    std::vector<std::string> names;
    for (const auto& [name, power] : powers)
        if (power > 0 && power / total * photons < least_photons) names.push_back(name);
    return names;
}

}  // namespace brewster
