#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb::suites {

/// A generator of n points of [0,1)^D, as in PointSet.
template <int D>
using Generate = std::function<std::vector<Point<D>>(std::uint64_t n, RandomStream&)>;

// Point sets with a known defect serve as mutants of several claims.

/// Points whose x is moved to the fraction c of its way from the left edge of its interval: of n strata of the grid's
/// columns (stratified), or of the cube (strata = 1).
template <int D>
Generate<D> left_part_of_strata(Generate<D> generate, std::function<std::uint64_t(std::uint64_t n)> strata, double c);

/// Scrambled sets whose digits beyond the first `digits` were left at zero.
template <int D>
Generate<D> few_digits(Generate<D> generate, int digits);

/// Points shifted uniformly in [0, c)^D only.
template <int D>
Generate<D> short_shift(std::vector<Point<D>> (*points)(std::uint64_t), double c);

/// Shifted points that stay outside where they leave the cube.
template <int D>
Generate<D> shift_without_wrap(std::vector<Point<D>> (*points)(std::uint64_t));

/// Points shifted alike on both axes.
Generate<2> shift_shared_by_axes(std::vector<Point<2>> (*points)(std::uint64_t));

/// A Latin hypercube in which every row swaps with a random one of all rows: some permutations are more likely than
/// others.
std::vector<Point<2>> latin_hypercube_by_naive_shuffle(std::uint64_t n, RandomStream& random);
/// A Latin hypercube with the same permutation on both axes: all points are near a diagonal.
std::vector<Point<2>> latin_hypercube_with_one_permutation(std::uint64_t n, RandomStream& random);
/// A Latin hypercube with rows drawn independently, not by a permutation.
std::vector<Point<2>> latin_hypercube_with_repeated_rows(std::uint64_t n, RandomStream& random);
/// Multi-jittered points whose place within a column is set by the column, and within a row by the row.
std::vector<Point<2>> multi_jittered_by_own_index(std::uint64_t n, RandomStream& random);
/// Points with a permutation of its own for each column and each row: multi-jittered, not correlated [Chiu, Shirley &
/// Wang 1994].
std::vector<Point<2>> multi_jittered_uncorrelated(std::uint64_t n, RandomStream& random);
/// Points with a permutation of its own for each row; all columns share one.
std::vector<Point<2>> multi_jittered_half_correlated(std::uint64_t n, RandomStream& random);
/// Points without permutations: the canonical arrangement of [Chiu, Shirley & Wang 1994] before it is shuffled.
std::vector<Point<2>> multi_jittered_unshuffled(std::uint64_t n, RandomStream& random);

/// Sobol's sequence without its first point, as Boost.Random numbers it.
std::vector<Point<2>> sobol_without_origin(std::uint64_t n);
/// Van der Corput's sequence with the same digits flipped in every point: uniform, but without averaging.
std::vector<Point<1>> xor_van_der_corput(std::uint64_t n, RandomStream& random);
/// Hammersley's points with (i + 1)/n on the first axis.
std::vector<Point<2>> hammersley_from_one(std::uint64_t n);

}  // namespace plumb::suites
