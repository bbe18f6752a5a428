#include "verification/pictures/picture_copies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

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
    double largest = -INFINITY, largest_original = -INFINITY;
    std::size_t at_largest = 0;
    bool same = true, of_halves = true;
    double least_ratio = INFINITY, largest_ratio = -INFINITY;
    std::set<double> levels = {}, original_levels = {};

    void add_range(double original, double copy) {
        largest = std::max(largest, copy);
        largest_original = std::max(largest_original, original);
    }
    [[nodiscard]] bool cut_off() const { return largest_original > largest && at_largest > 1; }
    void add(double original, double copy) {
        at_largest += copy == largest;
        if (copy == largest && original >= copy) return;  // perhaps cut off
        levels.insert(copy);
        original_levels.insert(original);
        same = same && copy == original;
        of_halves = of_halves && std::abs(copy - original) <= std::max(0x1p-11 * 1.001 * std::abs(original), 0x1p-25);
        if (original == 0) return;
        least_ratio = std::min(least_ratio, copy / original);
        largest_ratio = std::max(largest_ratio, copy / original);
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
    else if (found.largest_ratio - found.least_ratio <= 1e-5 * std::abs(found.largest_ratio))
        words.push_back(fmt::format("multiplied by {:.6g}", found.largest_ratio));
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
    Treatment found;
    const auto each = [&](auto visit) {
        for (const Pairs& pairs : channels)
            for (const auto& [first, second] : pairs) a_is_original ? visit(first, second) : visit(second, first);
    };
    each([&](double original, double copy) { found.add_range(original, copy); });
    each([&](double original, double copy) { found.add(original, copy); });
    const std::vector<std::string> words = words_of(found);
    const char *copy = a_is_original ? "b" : "a", *original = a_is_original ? "a" : "b";
    return fmt::format("{} is a copy of {}{}{}, the same samples and no second estimate", copy, original,
                       words.empty() ? "" : ", ", fmt::join(words, " and "));
}

}  // namespace plumb
