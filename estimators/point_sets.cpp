#include "estimators/halton.h"
#include "estimators/latin_hypercube.h"
#include "estimators/multi_jittered.h"
#include "estimators/point_set.h"
#include "estimators/point_set_slopes.h"
#include "estimators/random_shift.h"
#include "estimators/sobol.h"
#include "estimators/stratified.h"
#include "estimators/zero_two.h"

namespace plumb {
namespace {

/// A deterministic set as one that ignores the stream.
template <int D>
auto plain(std::vector<Point<D>> (*points)(std::uint64_t)) {
    return [points](std::uint64_t n, RandomStream&) { return points(n); };
}

template <int D>
auto shifted(std::vector<Point<D>> (*points)(std::uint64_t)) {
    return [points](std::uint64_t n, RandomStream& random) { return random_shift<D>(points(n), random); };
}

}  // namespace

const std::vector<PointSet<1>>& point_sets_1d() {
    static const std::vector<PointSet<1>> sets{
        {"independent", "Independent uniform points: plain Monte Carlo.", "[Metropolis & Ulam 1949]", true, true,
         independent_points<1>, independent_slope<1>},
        {"stratified", "One uniform point in each of n equal intervals.", "[Haber 1966]", true, false, stratified_1d,
         stratified_slope<1>},
        {"halton", "Van der Corput's sequence in base 2, origin first.", "[van der Corput 1935]", false, false,
         plain<1>(halton_1d), low_discrepancy_slope<1>},
        {"halton-shifted", "Van der Corput's sequence, moved on the torus by one random shift.",
         "[Cranley & Patterson 1976]", true, false, shifted<1>(halton_1d), low_discrepancy_slope<1>},
        {"hammersley", "The regular grid i/n: the left rectangle rule.", "[Hammersley 1960]", false, false,
         plain<1>(hammersley_1d), low_discrepancy_slope<1>},
        {"hammersley-shifted", "The regular grid, moved on the torus by one random shift: systematic sampling.",
         "[Cranley & Patterson 1976]", true, false, shifted<1>(hammersley_1d), low_discrepancy_slope<1>},
        {"sobol", "Sobol's sequence (first axis, Gray-code order), origin first.", "[Sobol' 1967; Joe & Kuo 2008]",
         false, false, plain<1>(sobol_1d), low_discrepancy_slope<1>},
        {"sobol-owen",
         "Sobol's sequence with nested uniform scrambling in base 2; stratified when n is a power of two.",
         "[Owen 1995]", true, false, owen_sobol_1d, owen_slope<1>},
    };
    return sets;
}

const std::vector<PointSet<2>>& point_sets_2d() {
    static const std::vector<PointSet<2>> sets{
        {"independent", "Independent uniform points: plain Monte Carlo.", "[Metropolis & Ulam 1949]", true, true,
         independent_points<2>, independent_slope<2>},
        {"stratified",
         "One uniform point in each cell of a grid, n = columns × rows by the divisors nearest each other (n × 1 for a "
         "prime).",
         "[Haber 1966]", true, false, stratified_2d, stratified_slope<2>},
        {"latin-hypercube", "One point in each of n columns and of n rows, paired by a random permutation.",
         "[McKay, Beckman & Conover 1979]", true, false, latin_hypercube_2d, latin_hypercube_slope},
        {"cmj",
         "Correlated multi-jittered: one point in each grid cell, column and row (n × 1 cells for a prime n); random "
         "permutations where the paper hashes.",
         "[Kensler 2013]", true, false, correlated_multi_jittered_2d, multi_jittered_slope},
        {"halton", "Halton's sequence in the bases 2 and 3, origin first.", "[Halton 1960]", false, false,
         plain<2>(halton_2d), low_discrepancy_slope<2>},
        {"halton-shifted", "Halton's sequence, moved on the torus by one random shift.", "[Cranley & Patterson 1976]",
         true, false, shifted<2>(halton_2d), low_discrepancy_slope<2>},
        {"hammersley", "Hammersley's set: i/n and the radical inverse in base 2.", "[Hammersley 1960]", false, false,
         plain<2>(hammersley_2d), low_discrepancy_slope<2>},
        {"hammersley-shifted", "Hammersley's set, moved on the torus by one random shift.",
         "[Cranley & Patterson 1976]", true, false, shifted<2>(hammersley_2d), low_discrepancy_slope<2>},
        {"sobol", "Sobol's sequence (first two axes, Gray-code order), origin first.", "[Sobol' 1967; Joe & Kuo 2008]",
         false, false, plain<2>(sobol_2d), low_discrepancy_slope<2>},
        {"sobol-owen", "Sobol's sequence with nested uniform scrambling in base 2.", "[Owen 1995]", true, false,
         owen_sobol_2d, owen_slope<2>},
        {"zero-two", "The (0,2)-sequence in base 2 by index; where n is a power of two the same set as sobol.",
         "[Kollig & Keller 2002]", false, false, plain<2>(zero_two), low_discrepancy_slope<2>},
        {"zero-two-xor", "The (0,2)-sequence with random digit scrambling (one random xor an axis).",
         "[Kollig & Keller 2002]", true, false, xor_zero_two, low_discrepancy_slope<2>},
        {"zero-two-owen", "The (0,2)-sequence with nested uniform scrambling in base 2.", "[Owen 1995]", true, false,
         owen_zero_two, owen_slope<2>},
    };
    return sets;
}

}  // namespace plumb
