#include "verification/verdict.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

#include "core/named.h"

namespace plumb {

std::string to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::holds: return "holds";
        case Outcome::refuted: return "refuted";
        case Outcome::undecided: return "undecided";
    }
    throw std::logic_error("an Outcome outside its enumeration");
}

std::ostream& operator<<(std::ostream& out, Outcome outcome) {
    return out << to_string(outcome);
}

Outcome outcome_from(std::string_view text) {
    static constexpr std::array outcomes{Outcome::holds, Outcome::refuted, Outcome::undecided};
    return find_named(outcomes, text, "outcome", [](Outcome outcome) { return to_string(outcome); });
}

std::string to_string(Kind kind) {
    switch (kind) {
        case Kind::exact: return "exact";
        case Kind::bounded: return "bounded";
        case Kind::distribution: return "distribution";
        case Kind::mean: return "mean";
        case Kind::ratio: return "ratio";
        case Kind::rate: return "rate";
        case Kind::cost: return "cost";
    }
    throw std::logic_error("a Kind outside its enumeration");
}

std::string describe(const Verdict& verdict) {
    return fmt::format("{}: {} ({} samples)", to_string(verdict.outcome), verdict.reason, verdict.samples);
}

std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
    return out << describe(verdict);
}

Verdict all_of(std::vector<Verdict> parts) {
    if (parts.empty()) throw std::logic_error("all_of() of no verdicts");
    const auto severity = [](const Verdict& v) {
        return v.outcome == Outcome::refuted ? 2 : v.outcome == Outcome::undecided ? 1 : 0;
    };
    const auto decisive = std::ranges::max_element(parts, {}, severity);  // the first of the most severe
    Verdict joined = *decisive;
    joined.samples = 0;
    joined.series.clear();
    joined.stability.clear();
    for (Verdict& part : parts) {
        joined.samples += part.samples;
        std::ranges::move(part.series, std::back_inserter(joined.series));
        std::ranges::move(part.stability, std::back_inserter(joined.stability));
    }
    joined.evidence.emplace_back("parts", static_cast<std::uint64_t>(parts.size()));
    return joined;
}

}  // namespace plumb
