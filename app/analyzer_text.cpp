#include "app/analyzer_text.h"

#include "app/numbers.h"

namespace brewster {

std::optional<Analyzer> parse_analyzer(std::string_view text) {
    if (text == "none") return Analyzer{};
    if (text == "right") return Analyzer{Analyzer::Kind::right};
    if (text == "left") return Analyzer{Analyzer::Kind::left};
    if (const std::optional<double> angle = parse_number(text)) return Analyzer{Analyzer::Kind::linear, *angle};
    return std::nullopt;
}

std::string analyzer_text(const Analyzer& analyzer) {
    switch (analyzer.kind) {
        case Analyzer::Kind::none:
            break;
        case Analyzer::Kind::linear:
            return exact_text(analyzer.angle);
        case Analyzer::Kind::right:
            return "right";
        case Analyzer::Kind::left:
            return "left";
    }
    return "none";
}

}  // namespace brewster
