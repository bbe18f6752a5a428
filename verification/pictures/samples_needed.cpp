#include "verification/pictures/samples_needed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

constexpr double power = 0.9;

/// The next number of two digits.
double rounded_up(double x) {
    const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
    return std::ceil(x / unit - 1e-9) * unit;
}

/// What they have now, times the factor; empty where one does not say.
std::string samples_of(double factor, const std::vector<const Picture*>& sides) {
    std::vector<std::string> counts;
    for (const Picture* side : sides) {
        if (side->samples <= 0) return "";
        counts.push_back(fmt::format("{:.0f}", rounded_up(factor * side->samples)));
    }
    if (counts.empty()) return "";
    return fmt::format(" ({} a pixel)", fmt::join(counts, " and "));
}

}  // namespace

double more_samples(const MeanDifference& found, double epsilon, double level, double beta) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double error = found.standard_error, off = std::abs(found.difference);
    if (!(error > 0)) return never;
    const double margin = normal_upper_quantile(1 - power), z = student_upper_quantile(beta, found.degrees);
    const double half_width = (found.interval.high - found.interval.low) / 2;
    const double rounding = std::max(0.0, half_width - z * error);  // which no sample lessens
    const double truth = off > half_width ? off : 0;
    const double room = found.delta - truth - rounding, beyond = truth - epsilon - rounding;
    const double to_hold = room > 0 ? std::pow((z + margin) * error / room, 2) : never;
    const double refuting = student_upper_quantile(level / 2, found.degrees);
    const double to_refute = beyond > 0 ? std::pow((refuting + margin) * error / beyond, 2) : never;
    const double to_trust = std::pow(found.skewness * std::pow(normal_upper_quantile(beta), 3) / 3, 2);
    return std::max({2.0, std::min(to_hold, to_refute), to_trust});
}

void SamplesNeeded::add(const MeanDifference& found, TileState state) {
    if (state == TileState::same || state == TileState::differs) return;
    const bool noisy = state == TileState::too_noisy || state == TileState::heavy_tails;
    unknown = unknown || !noisy;
    tails = tails || state == TileState::heavy_tails;
    if (noisy && found.more_samples > factor) factor = found.more_samples;
}

std::string words_of(const SamplesNeeded& needed, const std::vector<const Picture*>& sides) {
    if (needed.unknown) return "how many samples would decide it is not known";
    if (needed.factor <= 1) return "";
    if (std::isinf(needed.factor)) return "no number of samples would decide it";
    const std::string more =
        needed.factor < 1e6
            ? fmt::format("{:.0f} times as many samples{}", rounded_up(needed.factor), samples_of(needed.factor, sides))
            : "more than a million times as many samples";
    if (needed.tails) return "tails forbid a forecast: at least " + more + " would be needed";
    return "about " + more + (sides.size() > 1 ? " of both would decide it" : " would decide it");
}

}  // namespace plumb
