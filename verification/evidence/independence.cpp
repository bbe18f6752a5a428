#include "verification/evidence/independence.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/moments.h"
#include "verification/evidence/rare_values.h"

namespace plumb {
namespace {

constexpr std::size_t least_ranked = 64;
constexpr double z_of_correlation = 5.33;  // 1e-7, two-sided: five lags take 5e-7

constexpr std::size_t most_counted = 8192, fewest_repeated = 64;

std::uint64_t hash(double value) {
    std::uint64_t h = std::bit_cast<std::uint64_t>(value);  // the finaliser of splitmix64 [Steele, Lea & Flood 2014]
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
    h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
    return h ^ (h >> 31);
}

bool single_precision(double value) {
    return static_cast<double>(static_cast<float>(value)) == value;
}

// Multiples of one step, as of a law on a grid: gaps between neighbours are multiples of the least.
bool on_a_grid(std::vector<double> values) {
    std::ranges::sort(values);
    double step = HUGE_VAL;
    for (std::size_t i = 1; i < values.size(); ++i) step = std::min(step, values[i] - values[i - 1]);
    const double rounding = 0x1p-50 * std::max(std::abs(values.front()), std::abs(values.back())) / step;
    return std::ranges::adjacent_find(values, [&](double a, double b) {
               const double steps = (b - a) / step;
               return std::abs(steps - std::round(steps)) > rounding + 1e-6 * steps;
           }) == values.end();
}

// Ranks from −1/2 to 1/2, ties at their middle: bounded whatever the tails.
std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<std::uint32_t> order(values.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return values[i]; });
    std::vector<double> rank(values.size());
    const double n = static_cast<double>(values.size());
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
        const double middle = static_cast<double>(begin + end) / (2 * n) - 0.5;
        for (std::size_t i = begin; i < end; ++i) rank[order[i]] = middle;
    }
    return rank;
}

// Under independence the products of centred ranks have mean 0 and variance sigma^4 [Wald & Wolfowitz 1943] and the
// square of the ranks' skewness, which the guard of mean claims holds off the normal tail.
std::string of_correlation(const std::vector<double>& values) {
    if (values.size() < least_ranked) return {};
    const std::vector<double> rank = ranks(values);
    const Moments moments = Moments::of(rank);
    const double n = static_cast<double>(rank.size()), skewness = moments.skewness();
    if (!(skewness * skewness * std::pow(z_of_correlation, 3) <= 3 * std::sqrt(n))) return {};
    for (const std::size_t lag : {1, 2, 4, 8, 16}) {
        double sum = 0;
        for (std::size_t i = lag; i < rank.size(); ++i)
            sum += (rank[i] - moments.mean()) * (rank[i - lag] - moments.mean());
        const double pairs = static_cast<double>(rank.size() - lag), correlation = sum / (pairs * moments.variance());
        if (std::abs(correlation) * std::sqrt(pairs) > z_of_correlation)
            return fmt::format("draws are not independent: the ranks of values {} apart have the correlation {:.2f}",
                               lag == 1 ? "one" : std::to_string(lag), correlation);
    }
    return {};
}

}  // namespace

void Independence::count(double value) {
    const auto in_sample = [this](double x) { return zeros_ == 0 || hash(x) >> (64 - zeros_) == 0; };
    if (!in_sample(value)) return;
    ++counts_[std::bit_cast<std::uint64_t>(value)];
    while (counts_.size() > most_counted) {
        ++zeros_;
        std::erase_if(counts_, [&](const auto& one) { return !in_sample(std::bit_cast<double>(one.first)); });
    }
}

void Independence::add(std::span<const double> values) {
    const std::size_t room = most_ranked - std::min(first_.size(), most_ranked);
    first_.insert(first_.end(), values.begin(), values.begin() + std::min(room, values.size()));
    drawn_ += values.size();
    if (few_values_) return;
    for (const double value : values) count(value);
    few_values_ = drawn_ >= 4096 && counts_.size() < fewest_repeated && zeros_ == 0;
}

// A generator with few seeds or a short period draws from a list of m values, each as likely as the next: of counts N
// that are Poisson with one mean, E N · E N(N−1)(N−2) = (E N(N−1))², and less for a period; a law with atoms has more.
// The list matters once there are draws enough to repeat most of it.
std::string Independence::of_repeated_values() const {
    double kept = 0;
    for (const auto& [bits, n] : counts_) kept += static_cast<double>(n);
    double once = 0, pairs = 0, triples = 0;
    std::vector<double> repeated;
    bool single = true;
    for (const auto& [bits, n] : counts_) {
        const double times = static_cast<double>(n);
        if (times > kept / 32) continue;  // an atom
        once += times;
        pairs += times * (times - 1);
        triples += times * (times - 1) * (times - 2);
        if (n < 2) continue;
        repeated.push_back(std::bit_cast<double>(bits));
        single = single && single_precision(repeated.back());
    }
    const bool list = repeated.size() >= fewest_repeated && pairs >= once / 2 && once * triples <= 1.1 * pairs * pairs;
    if (!list || single || on_a_grid(repeated)) return {};
    const auto different = static_cast<std::uint64_t>(std::ldexp(static_cast<double>(counts_.size()), zeros_));
    return fmt::format(
        "draws are not independent: {} of them have {}{} different values, all about as often: a generator of few "
        "seeds or a short period",
        with_commas(drawn_), zeros_ > 0 ? "about " : "", with_commas(different));
}

std::string Independence::complaint() const {
    if (std::string of_values = of_repeated_values(); !of_values.empty()) return of_values;
    return of_correlation(first_);
}

std::string complaint_of_state(const std::function<double(RandomStream&)>& draw, std::span<const double> first,
                               const Run& run) {
    const auto [least, most] = std::ranges::minmax(first);
    for (std::size_t i = 0; i < std::min(draws_again, first.size()); ++i) {
        RandomStream random = run.random(i);
        const double value = draw(random);
        if (std::abs(value - first[i]) > 1e-6 * (most - least))
            return fmt::format(
                "draws are not independent of those before them: number {} was {:.9g} and is {:.9g} when its random "
                "numbers are given again, so the draw keeps a state",
                i, first[i], value);
    }
    return {};
}

}  // namespace plumb
