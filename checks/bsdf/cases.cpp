#include "checks/bsdf/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "checks/bsdf/directions.h"
#include "core/parallel.h"
#include "verification/evidence/deterministic.h"

namespace plumb::checks {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double excess(const Case& c) {
    const double beyond = c.error - c.known;
    return std::isnan(beyond) ? infinity : beyond;
}

std::string place_of(const Case& c) {
    return length_squared(c.wi) > 0 ? in_words(c.wo, c.wi) : "wo " + name_of(c.wo);
}

// The constant by which found/expected/factor differs from 1, where it is one in 19 of 20 cases.
std::optional<double> constant_beside(const std::vector<Case>& cases, const Factor& factor) {
    constexpr std::size_t least = 8;
    std::vector<std::pair<double, double>> ratios;  // with what is known of each
    for (const Case& c : cases)
        if (!c.one_sided && c.expected > 0 && std::isfinite(c.found) && c.known < 0.01)
            ratios.emplace_back(c.found / c.expected / factor.of(c.wo, c.wi), c.known);
    if (ratios.size() < least) return {};
    std::ranges::sort(ratios);
    const double middle = ratios[ratios.size() / 2].first;
    const auto met = std::ranges::count_if(
        ratios, [&](const auto& ratio) { return std::abs(ratio.first / middle - 1) < 1e-3 + 2 * ratio.second; });
    return 20 * static_cast<std::size_t>(met) >= 19 * ratios.size() ? std::optional(middle) : std::nullopt;
}

std::optional<std::string> likely_factor(const std::vector<Case>& cases, const Demand& demand) {
    std::vector<Factor> factors{{"", [](Vec3, Vec3) { return 1; }}};
    factors.insert(factors.end(), demand.factors.begin(), demand.factors.end());
    for (const Factor& factor : factors) {
        const auto constant = constant_beside(cases, factor);
        if (!constant) continue;
        const bool one = std::abs(*constant - 1) < 1e-3;
        if (factor.name.empty() && one) return {};  // most are right
        if (factor.name.empty()) return fmt::format("{:.4g}", *constant);
        return one ? factor.name : fmt::format("{:.4g} {}", *constant, factor.name);
    }
    return {};
}

std::string cause_of(const std::vector<Case>& cases, const Case& worst, const Demand& demand) {
    const std::string_view cause = worst.cause;
    if (cause.empty()) return "";
    std::vector<Case> alike;
    for (const Case& c : cases)
        if (c.cause == cause) alike.push_back(c);
    const auto factor = likely_factor(alike, demand);
    return factor ? "; likely cause: " + fmt::format(fmt::runtime(cause), *factor) : "";
}

Verdict of_the_worst(const Case& worst, std::size_t cases, std::size_t coarse, const Demand& demand) {
    Verdict verdict;
    verdict.samples = cases;
    verdict.statistic = worst.error;
    verdict.resolution = demand.bound + worst.known;
    verdict.deviation = {0, worst.error};
    verdict.reason = fmt::format("worst of {} cases: {:.3g} {} ({}: {:.7g} for {:.7g}; {}); claimed: at most {:.3g} {}",
                                 cases, worst.error, demand.unit, worst.of, worst.found, worst.expected,
                                 place_of(worst), demand.bound, demand.unit);
    if (worst.known > demand.bound / 10)
        verdict.reason += fmt::format(", beyond {:.2g} that rounding or quadrature may have done", worst.known);
    if (coarse > 0) verdict.reason += fmt::format("; {} further cases are known too coarsely", coarse);
    verdict.evidence = {{"worst_case", fmt::format("{}; {}", worst.of, place_of(worst))},
                        {"found", worst.found},
                        {"expected", worst.expected},
                        {"worst_error", worst.error},
                        {"known_error", worst.known},
                        {"bound", demand.bound},
                        {"unit", demand.unit}};
    return verdict;
}

}  // namespace

Case equal(const char* of, Vec3 wo, Vec3 wi, double found, double expected) {
    const double error = found == expected ? 0 : expected == 0 ? infinity : std::abs(found / expected - 1);
    return {.of = of, .wo = wo, .wi = wi, .found = found, .expected = expected, .error = error};
}

Case equal(const char* of, Vec3 wo, Vec3 wi, const Spectrum& found, const Spectrum& expected) {
    const auto difference = [&](std::size_t lane) { return std::abs(found[lane] - expected[lane]); };
    std::size_t worst = 0;
    for (std::size_t lane = 1; lane < 4; ++lane)
        if (!(difference(lane) <= difference(worst))) worst = lane;
    Case c = equal(of, wo, wi, found[worst], expected[worst]);
    if (found == expected) return c;
    c.error = largest(expected) > 0 ? difference(worst) / largest(expected) : infinity;
    return c;
}

Verdict judged(const std::vector<Case>& cases, const Demand& demand) {
    if (cases.empty()) return exactly(true, 0, demand.nothing);
    std::vector<Case> sharp;
    for (const Case& c : cases)
        if (!(c.known > demand.coarse) || excess(c) > demand.bound) sharp.push_back(c);
    const auto badness = [](const Case& c) { return std::pair(std::max(0.0, excess(c)), c.error); };
    const Case& worst = *std::ranges::max_element(sharp.empty() ? cases : sharp, {}, badness);
    Verdict verdict = of_the_worst(worst, sharp.size(), cases.size() - sharp.size(), demand);
    if (excess(worst) > demand.bound) {
        verdict.outcome = Outcome::refuted;
        verdict.reason += cause_of(sharp, worst, demand);
    } else if (2 * sharp.size() >= cases.size()) {
        verdict.outcome = Outcome::holds;
    }
    return verdict;
}

std::vector<Case> gathered(std::size_t count, const std::function<std::vector<Case>(std::size_t)>& cases_of) {
    std::vector<std::vector<Case>> parts(count);
    for_batches(count, [&](std::size_t i) { parts[i] = cases_of(i); });
    std::vector<Case> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace plumb::checks
