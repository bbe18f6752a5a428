#pragma once

#include <cstdint>
#include <vector>

namespace plumb::checks {

/// What is furthest from uniform among numbers in [0,1], and how likely independent uniform numbers show as much.
struct Unevenness {
    double low = 0, high = 1;  ///< the interval
    double found = 0;          ///< the share of the numbers in it
    double p_value = 1;        ///< an upper bound that holds for any number of numbers
};

/// Counts of numbers that are claimed to be independent and uniform on [0,1], such as cumulative probabilities of
/// samples; in 2^12 bins, which is as fine as it looks.
class Uniformity {
public:
    static constexpr int levels = 12;
    void add(double u);

    /// Kolmogorov and Smirnov's distance, by intervals [0, u]; its tail by the bound 2 exp(−2 n D²)
    /// [Massart 1990].
    [[nodiscard]] Unevenness cumulative() const;
    /// The worst of all halves, quarters, … 4096ths, by Chernoff's bound of the binomial tails, times their number.
    [[nodiscard]] Unevenness dyadic() const;

private:
    std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(std::size_t{1} << levels);
    std::uint64_t count_ = 0;
};

}  // namespace plumb::checks
