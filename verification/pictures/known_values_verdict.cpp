#include "verification/pictures/known_values_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/pictures/samples_needed.h"

namespace plumb {
namespace {

std::string count_of(const ValuesCheck& check, std::size_t count, const char* what) {
    return fmt::format("{} of {} values {}", count, check.values.size(), what);
}

std::string place_of(const CheckedValue& value, const Picture& picture, std::span<const KnownValue> known) {
    return fmt::format("{} of {}", picture.channels[value.channel], known[value.known].name);
}

/// The values in such a state, and of these the one that is furthest off, in units of its delta.
template <class Which>
std::pair<std::size_t, const CheckedValue*> worst_of(const ValuesCheck& check, Which which) {
    const auto off = [](const CheckedValue& v) {
        const double difference = std::abs(v.found.difference);
        if (v.found.delta > 0) return difference / v.found.delta;
        return difference > 0 ? std::numeric_limits<double>::infinity() : 0;
    };
    std::size_t count = 0;
    const CheckedValue* worst = nullptr;
    for (const CheckedValue& value : check.values) {
        if (!which(value.state)) continue;
        ++count;
        if (!worst || off(value) > off(*worst)) worst = &value;
    }
    return {count, worst};
}

/// The channel whose values, taken together, are furthest off.
const CheckedTogether& worst_together(const ValuesCheck& check) {
    return *std::ranges::max_element(check.together, {}, [](const CheckedTogether& t) {
        return std::max(-t.found.interval.low, t.found.interval.high);
    });
}

std::string text_of(const CheckedTogether& together, const Picture& picture) {
    const MeanDifference& found = together.found;
    return fmt::format("their mean of {} is {:+.3g} % off, between {:+.3g} and {:+.3g} %",
                       picture.channels[together.channel], 100 * found.difference, 100 * found.interval.low,
                       100 * found.interval.high);
}

std::string refutation(const ValuesCheck& check, const Picture& picture, std::span<const KnownValue> known) {
    const auto [wrong, worst] = worst_of(check, [](TileState s) { return s == TileState::differs; });
    std::string text;
    if (worst)
        text = fmt::format("{}, most of all {}: found {:.5g}, known {:.5g}",
                           count_of(check, wrong, wrong == 1 ? "is wrong" : "are wrong"),
                           place_of(*worst, picture, known), worst->found.a, worst->found.b);
    for (const CheckedTogether& all : check.together)
        if (all.state == TileState::differs)
            text += fmt::format("{}together {} values are wrong: {}", text.empty() ? "" : "; ", all.values,
                                text_of(all, picture));
    return text;
}

/// Whether all values together are as known, and none of them is worse than too noisy to tell.
bool holds_together(const ValuesCheck& check) {
    return !check.together.empty() &&
           std::ranges::all_of(check.together, [](const auto& t) { return t.state == TileState::same; }) &&
           std::ranges::all_of(check.values, [](const CheckedValue& v) {
               return v.state == TileState::same || v.state == TileState::too_noisy;
           });
}

std::string held_together(const ValuesCheck& check, const Picture& picture) {
    double widest = 0;
    std::size_t noisy = 0;
    for (const CheckedValue& value : check.values) {
        if (value.state != TileState::too_noisy) continue;
        ++noisy;
        const Interval& interval = value.found.interval;
        const double scale = std::abs(value.found.b) > 0 ? std::abs(value.found.b) : value.found.delta;
        widest = std::max(widest, std::max(-interval.low, interval.high) / scale);
    }
    return fmt::format("together all {} values are as known: {}; alone {} too noisy to tell, the worst within {:.2g} %",
                       check.values.size(), text_of(worst_together(check), picture),
                       noisy == 1 ? "1 is" : fmt::format("{} are", noisy), 100 * widest);
}

std::string doubt(const ValuesCheck& check, const Picture& picture, std::span<const KnownValue> known) {
    const auto [open, worst] =
        worst_of(check, [](TileState s) { return s != TileState::same && s != TileState::differs; });
    SamplesNeeded needed;
    for (const CheckedTogether& together : check.together) needed.add(together.found, together.state);
    for (const CheckedValue& value : check.values)
        if (check.together.empty() || value.state != TileState::too_noisy) needed.add(value.found, value.state);
    std::string text =
        fmt::format("{}, least of all {} ({})", count_of(check, open, open == 1 ? "is not decided" : "are not decided"),
                    place_of(*worst, picture, known), to_string(worst->state));
    if (!check.together.empty() && worst_together(check).values > 0)
        text += "; together " + text_of(worst_together(check), picture);
    const std::string more = words_of(needed, {&picture});
    return more.empty() ? text : text + "; " + more;
}

}  // namespace

Verdict verdict_of(const ValuesCheck& check, const Picture& picture, std::span<const KnownValue> known,
                   const CheckSettings& settings) {
    Verdict verdict;
    verdict.samples = check.values.size();
    verdict.resolution = settings.delta;
    for (const CheckedValue& value : check.values)
        if (value.state != TileState::same) verdict.p_value = std::fmin(verdict.p_value, value.found.p_value);
    const auto said = [&](Outcome outcome, std::string reason) {
        verdict.outcome = outcome;
        verdict.reason = std::move(reason);
        return verdict;
    };
    if (std::string wrong = refutation(check, picture, known); !wrong.empty())
        return said(Outcome::refuted, std::move(wrong));
    if (std::ranges::all_of(check.values, [](const CheckedValue& v) { return v.state == TileState::same; }))
        return said(Outcome::holds, fmt::format("all {} values are as known, within {:.3g} %", check.values.size(),
                                                100 * settings.delta));
    if (holds_together(check)) return said(Outcome::holds, held_together(check, picture));
    return said(Outcome::undecided, doubt(check, picture, known));
}

}  // namespace plumb
