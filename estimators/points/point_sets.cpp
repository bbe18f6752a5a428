#include "estimators/points/halton.h"
#include "estimators/points/latin_hypercube.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/point_set.h"
#include "estimators/points/point_set_slopes.h"
#include "estimators/points/random_shift.h"
#include "estimators/points/sobol.h"
#include "estimators/points/stratified.h"
#include "estimators/points/zero_two.h"
#include "estimators/replicates/independent_slope.h"

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
        {.id = "independent",
         .summary = "Independent uniform points: plain Monte Carlo.",
         .source = "[Metropolis & Ulam 1949]",
         .independent = true,
         .generate = independent_points<1>,
         .expected_slope = independent_slope<1>},
        {.id = "stratified",
         .summary = "One uniform point in each of n equal intervals.",
         .source = "[Haber 1966]",
         .generate = stratified_1d,
         .expected_slope = stratified_slope<1>},
        {.id = "halton",
         .summary = "Van der Corput's sequence in base 2, origin first.",
         .source = "[van der Corput 1935]",
         .randomised = false,
         .generate = plain<1>(halton_1d),
         .expected_slope = low_discrepancy_slope<1>},
        {.id = "halton-shifted",
         .summary = "Van der Corput's sequence, moved on the torus by one random shift.",
         .source = "[Cranley & Patterson 1976]",
         .generate = shifted<1>(halton_1d),
         .expected_slope = low_discrepancy_slope<1>},
        {.id = "hammersley",
         .summary = "The regular grid i/n: the left rectangle rule.",
         .source = "[Hammersley 1960]",
         .randomised = false,
         .generate = plain<1>(hammersley_1d),
         .expected_slope = low_discrepancy_slope<1>},
        {.id = "hammersley-shifted",
         .summary = "The regular grid, moved on the torus by one random shift: systematic sampling.",
         .source = "[Cranley & Patterson 1976]",
         .generate = shifted<1>(hammersley_1d),
         .expected_slope = low_discrepancy_slope<1>},
        {.id = "sobol",
         .summary = "Sobol's sequence (first axis, Gray-code order), origin first.",
         .source = "[Sobol' 1967; Joe & Kuo 2008]",
         .randomised = false,
         .generate = plain<1>(sobol_1d),
         .expected_slope = low_discrepancy_slope<1>},
        {.id = "sobol-owen",
         .summary = "Sobol's sequence with nested uniform scrambling in base 2; stratified when n is a power of two.",
         .source = "[Owen 1995]",
         .generate = owen_sobol_1d,
         .expected_slope = owen_slope<1>},
    };
    return sets;
}

const std::vector<PointSet<2>>& point_sets_2d() {
    static const std::vector<PointSet<2>> sets{
        {.id = "independent",
         .summary = "Independent uniform points: plain Monte Carlo.",
         .source = "[Metropolis & Ulam 1949]",
         .independent = true,
         .generate = independent_points<2>,
         .expected_slope = independent_slope<2>},
        {.id = "stratified",
         .summary = "One uniform point in each cell of a grid: n = columns × rows, the divisors nearest each other (n "
                    "× 1 for a prime).",
         .source = "[Haber 1966]",
         .generate = stratified_2d,
         .expected_slope = stratified_slope<2>},
        {.id = "latin-hypercube",
         .summary = "One point in each of n columns and of n rows, paired by a random permutation.",
         .source = "[McKay, Beckman & Conover 1979]",
         .generate = latin_hypercube_2d,
         .expected_slope = latin_hypercube_slope},
        {.id = "cmj",
         .summary = "Correlated multi-jittered: one point in each grid cell (n × 1 for a prime), column and row; true "
                    "permutations, no hash.",
         .source = "[Kensler 2013]",
         .generate = correlated_multi_jittered_2d,
         .expected_slope = multi_jittered_slope},
        {.id = "halton",
         .summary = "Halton's sequence in the bases 2 and 3, origin first.",
         .source = "[Halton 1960]",
         .randomised = false,
         .generate = plain<2>(halton_2d),
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "halton-shifted",
         .summary = "Halton's sequence, moved on the torus by one random shift.",
         .source = "[Cranley & Patterson 1976]",
         .generate = shifted<2>(halton_2d),
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "hammersley",
         .summary = "Hammersley's set: i/n and the radical inverse in base 2.",
         .source = "[Hammersley 1960]",
         .randomised = false,
         .generate = plain<2>(hammersley_2d),
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "hammersley-shifted",
         .summary = "Hammersley's set, moved on the torus by one random shift.",
         .source = "[Cranley & Patterson 1976]",
         .generate = shifted<2>(hammersley_2d),
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "sobol",
         .summary = "Sobol's sequence (first two axes, Gray-code order), origin first.",
         .source = "[Sobol' 1967; Joe & Kuo 2008]",
         .randomised = false,
         .generate = plain<2>(sobol_2d),
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "sobol-owen",
         .summary = "Sobol's sequence with nested uniform scrambling in base 2.",
         .source = "[Owen 1995]",
         .generate = owen_sobol_2d,
         .expected_slope = owen_slope<2>},
        {.id = "zero-two",
         .summary = "The (0,2)-sequence in base 2 by index; where n is a power of two the same set as sobol.",
         .source = "[Kollig & Keller 2002]",
         .randomised = false,
         .generate = plain<2>(zero_two),
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "zero-two-xor",
         .summary = "The (0,2)-sequence with random digit scrambling (one random xor an axis).",
         .source = "[Kollig & Keller 2002]",
         .generate = xor_zero_two,
         .expected_slope = low_discrepancy_slope<2>},
        {.id = "zero-two-owen",
         .summary = "The (0,2)-sequence with nested uniform scrambling in base 2.",
         .source = "[Owen 1995]",
         .generate = owen_zero_two,
         .expected_slope = owen_slope<2>},
    };
    return sets;
}

}  // namespace plumb
