#include "app/numbers.h"
#include "app/output.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "base/log.h"

namespace brewster {
namespace {

std::string summary(const SolveResult& result) {
    const Progress& progress = result.progress;
    const auto photons = static_cast<double>(progress.photons);
    std::string text = result.scene + ": " + with_magnitude(photons) + " photons in " + significant(progress.seconds) +
                       " s (" + with_magnitude(progress.photons_per_second()) + " a second, " +
                       std::to_string(progress.photons_by_thread.size()) + " threads)\n";
    text += "  bounces    " + with_magnitude(static_cast<double>(progress.bounces)) + " (" +
            significant(static_cast<double>(progress.bounces) / photons) + " a photon)\n";
    text += "  bins       " + with_magnitude(static_cast<double>(progress.leaves)) + " tallied, " +
            with_magnitude(static_cast<double>(progress.published_leaves)) + " published, " +
            with_magnitude(static_cast<double>(progress.bytes)) + "B\n";
    text += "  error      " + significant(100 * progress.relative_error) + " %\n";
    text += std::string("  ledger     ") + (result.ledger.balances() ? "balances exactly" : "DOES NOT BALANCE") + "\n";
    text += "  trouble    " + std::to_string(progress.trouble) + "\n";
    text += "  digest     " + result.digest + "\n";
    return text;
}

}  // namespace

void solve(const SolveOptions& options) {
    if (options.json) log_only_warnings();
    const std::unique_ptr<Engine> engine = engine_for(options);
    trace(*engine, options.stop);
    if (!options.save.empty()) engine->save(options.save);
    const SolveResult result = result_of(*engine);
    print_result(options.json ? solve_report(result) : summary(result));
}

}  // namespace brewster
