#include "app/progress_line.h"

#include <algorithm>

#include "app/numbers.h"

namespace brewster {

double finished_share(const Progress& progress, const StopRule& rule) {
    double share = 0;
    if (rule.photons)
        share = std::max(share, static_cast<double>(progress.photons) / static_cast<double>(*rule.photons));
    if (rule.seconds) share = std::max(share, progress.seconds / *rule.seconds);
    if (rule.target_error && progress.relative_error > 0) {
        const double ratio = *rule.target_error / progress.relative_error;
        share = std::max(share, ratio * ratio);
    }
    return std::min(share, 1.0);
}

std::string progress_line(const Progress& progress, const StopRule& rule) {
    constexpr std::size_t cells = 30;
    const double share = finished_share(progress, rule);
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(cells));
    std::string line = "[" + std::string(filled, '#') + std::string(cells - filled, '.') + "] ";
    line += std::to_string(static_cast<int>(share * 100)) + " %  ";
    line += with_magnitude(static_cast<double>(progress.photons)) + " photons, ";
    line += with_magnitude(progress.photons_per_second()) + " a second";
    // Without a target the engine publishes rarely, and the newest error may be an old one.
    if (rule.target_error && progress.relative_error > 0)
        line += ", error " + significant(100 * progress.relative_error) + " %";
    return line;
}

}  // namespace brewster
