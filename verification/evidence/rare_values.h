#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace plumb {

// What a verdict rests on where nothing bounds the values: how many were seen. A value of probability p is missing
// among n independent ones with probability (1 − p)^n, and then no rule that looks at the data knows of it.
// docs/statistics.md, "Values that were never seen".

/// A value is taken for met when as many draws hold sixteen of it on average: all but e^-16 = 1e-7.
inline constexpr std::uint64_t draws_that_meet = 16;

/// The least that a test without bounds looks at, unless its claim says why fewer do: values of probability 2.4e-4 are
/// met, and those of 1e-4 but for 0.14 %.
inline constexpr std::uint64_t least_draws_without_bounds = std::uint64_t{1} << 16;

/// How many fresh draws must refute again what `draws` without bounds have refuted: several times as many, since the
/// same values can have been missing.
constexpr std::uint64_t confirming_draws(std::uint64_t draws) {
    return std::max(8 * least_draws_without_bounds, 4 * draws);
}

/// "values rarer than 1 in 4,096 could hide", after so many independent draws.
std::string what_could_hide(std::uint64_t draws);

/// 1234567 as "1,234,567".
std::string with_commas(std::uint64_t number);

}  // namespace plumb
