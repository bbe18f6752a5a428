#include "verification/pictures/picture_copies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/interval.h"

namespace plumb {
namespace {

/// Numbers of two pictures at the same places, of one channel, by increasing order of the first and then the second.
using Pairs = std::vector<std::pair<double, double>>;

constexpr std::size_t enough = 16;  // different numbers, for an order to say something

Pairs pairs_of(const Picture& a, const Picture& b, std::size_t channel) {
    Pairs pairs;
    for (std::size_t k = channel; k < a.mean.size(); k += a.channels.size())
        if (std::isfinite(a.mean[k]) && std::isfinite(b.mean[k])) pairs.emplace_back(a.mean[k], b.mean[k]);
    std::ranges::sort(pairs);
    return pairs;
}

std::size_t different(const Pairs& pairs, double std::pair<double, double>::*which) {
    std::set<double> values;
    for (const auto& pair : pairs) values.insert(pair.*which);
    return values.size();
}

bool is_increasing(const Pairs& pairs) {
    return std::ranges::is_sorted(pairs, {}, [](const auto& pair) { return pair.second; });
}

/// What was done to the numbers of an original.
struct Treatment {
    double largest = -INFINITY;
    bool same = true, of_halves = true;
    std::vector<Interval> ratios;            // of copy to original, channel by channel
    std::map<double, Interval> levels = {};  // the originals of each number of the copy
    std::set<double> original_levels = {};

    void add_level(double original, double copy) {
        largest = std::max(largest, copy);
        Interval& originals = levels.try_emplace(copy, Interval{original, original}).first->second;
        originals = {std::min(originals.low, original), std::max(originals.high, original)};
    }
    /// Whether the largest number stands for larger ones than itself, and for more than any other does by rounding.
    [[nodiscard]] bool cut_off() const {
        const Interval top = levels.at(largest);
        return top.high > largest && std::ranges::all_of(levels, [&](const auto& level) {
                   return level.first == largest || level.second.width() < top.width();
               });
    }
    void add(std::size_t channel, double original, double copy, bool is_cut_off) {
        if (is_cut_off && copy == largest && original >= copy) return;
        original_levels.insert(original);
        same = same && copy == original;
        of_halves = of_halves && std::abs(copy - original) <= std::max(0x1p-11 * 1.001 * std::abs(original), 0x1p-25);
        if (original == 0) return;
        Interval& ratio = ratios[channel];
        ratio = {std::min(ratio.low, copy / original), std::max(ratio.high, copy / original)};
    }
    /// What each channel is multiplied by; empty where one is not.
    [[nodiscard]] std::vector<std::string> factors() const {
        std::vector<std::string> factors;
        for (const auto& [low, high] : ratios) {
            if (low > high) continue;  // black
            if (high - low > 1e-5 * std::abs(high)) return {};
            factors.push_back(fmt::format("{:.6g}", high));
        }
        if (std::ranges::all_of(factors, [&](const std::string& f) { return f == factors.front(); }))
            factors.resize(std::min<std::size_t>(1, factors.size()));
        return factors;
    }
};

std::vector<std::string> words_of(const Treatment& found) {
    std::vector<std::string> words;
    if (found.cut_off()) words.push_back(fmt::format("cut off at {:.4g}", found.largest));
    if (found.same) return words;
    if (found.of_halves)
        words.push_back("rounded to half floats");
    else if (found.levels.size() <= 3 * 256 && 2 * found.levels.size() < found.original_levels.size())
        words.push_back(fmt::format("rounded to {} levels, as few bits have", found.levels.size()));
    else if (const std::vector<std::string> factors = found.factors(); !factors.empty())
        words.push_back(fmt::format("multiplied by {}", fmt::join(factors, ", ")));
    else
        words.push_back("changed by a curve");
    return words;
}

}  // namespace

std::string copies_of(const Picture& a, const Picture& b) {
    std::vector<Pairs> channels;
    bool telling = false, a_is_original = true;
    for (std::size_t c = 0; c < a.channels.size(); ++c) {
        channels.push_back(pairs_of(a, b, c));
        if (!is_increasing(channels.back())) return "";
        const std::size_t of_a = different(channels.back(), &std::pair<double, double>::first),
                          of_b = different(channels.back(), &std::pair<double, double>::second);
        telling = telling || std::max(of_a, of_b) >= enough;
        a_is_original = a_is_original && of_a >= of_b;
    }
    if (!telling) return "";
    Treatment found{.ratios = std::vector<Interval>(channels.size(), {INFINITY, -INFINITY})};
    const auto each = [&](auto visit) {
        for (std::size_t c = 0; c < channels.size(); ++c)
            for (const auto& [first, second] : channels[c])
                a_is_original ? visit(c, first, second) : visit(c, second, first);
    };
    each([&](std::size_t, double original, double copy) { found.add_level(original, copy); });
    const bool is_cut_off = found.cut_off();
    each([&](std::size_t c, double original, double copy) { found.add(c, original, copy, is_cut_off); });
    const std::vector<std::string> words = words_of(found);
    const char *copy = a_is_original ? "b" : "a", *original = a_is_original ? "a" : "b";
    return fmt::format("{} is a copy of {}{}{}, the same samples and no second estimate", copy, original,
                       words.empty() ? "" : ", ", fmt::join(words, " and "));
}

}  // namespace plumb
