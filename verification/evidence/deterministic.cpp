#include "verification/evidence/deterministic.h"

#include <algorithm>
#include <cmath>

namespace plumb {

Verdict exactly(bool equal, std::uint64_t cases, std::string statement_of_result) {
    Verdict verdict;
    verdict.outcome = equal ? Outcome::holds : Outcome::refuted;
    verdict.samples = cases;
    verdict.resolution = 0;
    verdict.deviation = equal ? Interval{0, 0} : Interval{};
    verdict.reason = std::move(statement_of_result);
    return verdict;
}

Verdict within_bound(const std::vector<BoundedCase>& cases, double bound, std::string unit) {
    Verdict verdict;
    if (cases.empty()) {
        verdict.reason = "no case was tried";
        return verdict;
    }
    const auto badness = [](const BoundedCase& c) {
        return std::isnan(c.error) ? std::numeric_limits<double>::infinity() : c.error;
    };
    const BoundedCase& worst = *std::ranges::max_element(cases, {}, badness);
    verdict.outcome = worst.error <= bound ? Outcome::holds : Outcome::refuted;
    verdict.samples = cases.size();
    verdict.statistic = worst.error;
    verdict.resolution = bound;
    verdict.deviation = {0, worst.error};
    verdict.reason =
        fmt::format("worst of {} cases: {} {} ({}); claimed: at most {} {}", cases.size(),
                    fmt::format("{:.3g}", worst.error), unit, worst.name, fmt::format("{:.3g}", bound), unit);
    verdict.evidence = {
        {"worst_case", worst.name}, {"worst_error", worst.error}, {"bound", bound}, {"unit", std::move(unit)}};
    return verdict;
}

Verdict stable(const std::vector<BoundedCase>& cases, double bound, std::string formula, std::string axis,
               std::string unit) {
    Verdict verdict = within_bound(cases, bound, unit);
    Stability plot{std::move(formula), std::move(axis), std::move(unit), bound, {}};
    for (const BoundedCase& c : cases) plot.points.push_back({c.name, c.x, c.error});
    verdict.stability.push_back(std::move(plot));
    return verdict;
}

Verdict cost_is(double counted, const Interval& claimed, std::string what) {
    Verdict verdict;
    verdict.outcome = claimed.contains(counted) ? Outcome::holds : Outcome::refuted;
    verdict.statistic = counted;
    verdict.resolution = claimed.width() / 2;
    const double off = counted - (claimed.low + claimed.high) / 2;
    verdict.deviation = {off, off};
    verdict.reason = claimed.low == claimed.high
                         ? fmt::format("{:.6g} {}; claimed {:.6g}", counted, what, claimed.low)
                         : fmt::format("{:.6g} {}; claimed {:.6g} … {:.6g}", counted, what, claimed.low, claimed.high);
    return verdict;
}

Verdict outcome_is(const Verdict& inner, Outcome demanded) {
    Verdict verdict = inner;
    verdict.outcome = inner.outcome == demanded ? Outcome::holds : Outcome::refuted;
    verdict.reason = fmt::format("the verdict is {}, as demanded: {}", to_string(inner.outcome), inner.reason);
    if (inner.outcome != demanded)
        verdict.reason =
            fmt::format("the verdict is {}, not {}: {}", to_string(inner.outcome), to_string(demanded), inner.reason);
    return verdict;
}

double ulp_error(double found, double truth) {
    if (found == truth) return 0;
    if (std::isnan(found) || std::isnan(truth) || std::isinf(found) || std::isinf(truth))
        return std::numeric_limits<double>::infinity();
    const double ulp = std::nextafter(std::abs(truth), std::numeric_limits<double>::infinity()) - std::abs(truth);
    return std::abs(found - truth) / ulp;
}

}  // namespace plumb
