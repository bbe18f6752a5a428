// Randomised point sets: a point picked at random is uniform, and the mean over a set is unbiased. Six points: no power
// of two, with a grid of 3 × 2.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/points/halton.h"
#include "estimators/points/latin_hypercube.h"
#include "estimators/points/mean_over.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/point_set.h"
#include "estimators/points/sobol.h"
#include "estimators/points/strata.h"
#include "estimators/points/stratified.h"
#include "estimators/points/zero_two.h"
#include "verification/claim.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/mean.h"
#include "verification/suites/points/defective_point_sets.h"

namespace plumb::suites {
namespace {

constexpr std::uint64_t n = 6;

// ---- One random point of each of many sets is uniform --------------------------------------------------------------

template <int D>
std::size_t cell_of(const Point<D>& point) {
    constexpr std::size_t cells = D == 1 ? 24 : 12;  // an axis: several to every stratum
    std::size_t cell = 0, all = 1;
    for (const double x : point) {
        if (!(0 <= x && x < 1)) return ~std::size_t{0};
        cell = cell * cells + equal_cell(x, cells);
        all *= cells;
    }
    return cell;
}

template <int D>
Verdict is_uniform(const Generate<D>& generate, const Run& run) {
    constexpr std::size_t cells = D == 1 ? 24 : 144;
    const auto draw = [&](RandomStream& random) {
        const auto points = generate(n, random);
        return cell_of<D>(points[random.below(points.size())]);
    };
    return distribution_is(draw, {std::vector<double>(cells, 1.0 / cells), 0.04}, run);
}

template <int D>
using Defective = Wrong<Generate<D>>;

template <int D>
void add_uniform(Catalogue& catalogue, const PointSet<D>& set, const std::vector<Defective<D>>& defective) {
    catalogue.add({
        .id = fmt::format("points/{}-{}d/uniform", set.id, D),
        .statement = fmt::format("A point picked at random from {} randomised sets is uniform.", set.id),
        .source = set.source,
        .kind = Kind::distribution,
        .trial = {is_uniform<D>, set.generate, defective},
    });
}

template <int D>
const PointSet<D>& named(const std::vector<PointSet<D>>& sets, std::string_view id) {
    const auto found = std::ranges::find(sets, id, &PointSet<D>::id);
    if (found == sets.end()) throw std::logic_error(fmt::format("no point set '{}'", id));
    return *found;
}

/// x^1.15 in place of x: a density error phi near 0.15.
template <int D>
std::vector<Point<D>> pressed_to_the_left(std::uint64_t count, RandomStream& random) {
    auto points = independent_points<D>(count, random);
    for (Point<D>& point : points) point[0] = std::pow(point[0], 1.15);
    return points;
}

std::uint64_t columns(std::uint64_t count) {
    return grid_of(count).columns;
}
std::uint64_t all(std::uint64_t count) {
    return count;
}

template <int D>
Generate<D> always(std::vector<Point<D>> (*points)(std::uint64_t)) {
    return [points](std::uint64_t count, RandomStream&) { return points(count); };
}

// Comments give the density error phi of each claim's smallest mutant; delta is 0.04.
void add_uniform_1d(Catalogue& catalogue) {
    const auto add = [&](std::string_view id, const std::vector<Defective<1>>& defective) {
        add_uniform<1>(catalogue, named(point_sets_1d(), id), defective);
    };
    add("independent", {{"pressed-to-the-left", "x to the power 1.15.", pressed_to_the_left<1>}});  // 0.13
    add("stratified", {{"short-jitter", "The jitter fills 93 % of a stratum.",                      // 0.13
                        left_part_of_strata<1>(stratified_1d, all, 0.93)}});
    add("halton-shifted",
        {{"short-shift", "The shift is uniform in [0, 0.92).", short_shift<1>(halton_1d, 0.92)},  // 0.087
         {"no-wrap", "Points shifted beyond 1 stay there.", shift_without_wrap<1>(halton_1d)}});
    add("hammersley-shifted",
        {{"short-shift", "The shift is uniform in [0, 0.92).", short_shift<1>(hammersley_1d, 0.92)},  // 0.087
         {"no-wrap", "Points shifted beyond 1 stay there.", shift_without_wrap<1>(hammersley_1d)}});
    add("sobol-owen", {{"seven-digits", "Only seven digits are scrambled.", few_digits<1>(owen_sobol_1d, 7)},  // 0.088
                       {"unscrambled", "Sobol's sequence as it is.", always<1>(sobol_1d)}});
}

void add_uniform_2d(Catalogue& catalogue) {
    const auto add = [&](std::string_view id, const std::vector<Defective<2>>& defective) {
        add_uniform<2>(catalogue, named(point_sets_2d(), id), defective);
    };
    add("independent", {{"pressed-to-the-left", "x to the power 1.15.", pressed_to_the_left<2>}});  // 0.13
    add("stratified", {{"short-jitter", "The jitter in x fills 93 % of a stratum.",                 // 0.13
                        left_part_of_strata<2>(stratified_2d, columns, 0.93)}});
    add("latin-hypercube",
        {{"naive-shuffle", "Each row swaps with a random one of all rows.", latin_hypercube_by_naive_shuffle},  // 0.10
         {"repeated-permutation", "The same permutation on both axes.", latin_hypercube_with_one_permutation}});
    add("cmj", {{"short-jitter", "The jitter in x fills 88 % of a fine column.",  // 0.14
                 left_part_of_strata<2>(correlated_multi_jittered_2d, all, 0.88)},
                {"not-permuted", "The canonical arrangement, not shuffled.", multi_jittered_unshuffled}});
    add("halton-shifted",
        {{"short-shift", "The shift is uniform in [0, 0.92)².", short_shift<2>(halton_2d, 0.92)},
         {"no-wrap", "Points shifted beyond 1 stay there.", shift_without_wrap<2>(halton_2d)},
         {"one-shift-for-both-axes", "Both axes are shifted by the same number.", shift_shared_by_axes(halton_2d)}});
    add("hammersley-shifted",
        {{"short-shift", "The shift is uniform in [0, 0.92)².", short_shift<2>(hammersley_2d, 0.92)},
         {"no-wrap", "Points shifted beyond 1 stay there.", shift_without_wrap<2>(hammersley_2d)},
         {"one-shift-for-both-axes", "Both axes are shifted by the same number.",
          shift_shared_by_axes(hammersley_2d)}});
    add("sobol-owen", {{"six-digits", "Only six digits are scrambled.", few_digits<2>(owen_sobol_2d, 6)},  // 0.125
                       {"unscrambled", "Sobol's sequence as it is.", always<2>(sobol_2d)}});
    add("zero-two-xor", {{"six-digits", "Only six digits are scrambled.", few_digits<2>(xor_zero_two, 6)}});    // 0.125
    add("zero-two-owen", {{"six-digits", "Only six digits are scrambled.", few_digits<2>(owen_zero_two, 6)}});  // 0.125
}

// ---- The mean over a set is unbiased -------------------------------------------------------------------------------

// ∫ e^(x+y) = (e − 1)², values in [1, e²]. Squeezing x into [0, c) changes it by (c − 1) (e/(e−1) − 1) + O((1−c)²) of
// itself: −1.15 % for c = 0.98, 2.3 delta.
Verdict is_unbiased(const Generate<2>& generate, const Run& run) {
    const double side = std::numbers::e - 1, truth = side * side;
    const Function<2> f = [](const Point<2>& p) { return std::exp(p[0] + p[1]); };
    const auto draw = [&](RandomStream& random) { return mean_over<2>(generate(n, random), f).value; };
    return mean_is(draw, {.reference = truth, .delta = 0.005 * truth, .bounds = {1, std::exp(2.0)}, .cap = 1 << 19},
                   run);
}

void add_unbiased(Catalogue& catalogue) {
    for (const PointSet<2>& set : point_sets_2d()) {
        if (!set.randomised) continue;
        const auto one = [](std::uint64_t) { return std::uint64_t{1}; };
        std::vector<Defective<2>> defective{{"squeezed", "No point lies in the last fiftieth of the first axis.",
                                             left_part_of_strata<2>(set.generate, one, 0.98)}};
        if (set.id == "sobol-owen")
            defective.push_back({"unscrambled", "Sobol's sequence as it is.", always<2>(sobol_2d)});
        if (set.id == "latin-hypercube")
            defective.push_back(
                {"repeated-permutation", "The same permutation on both axes.", latin_hypercube_with_one_permutation});
        catalogue.add({
            .id = fmt::format("points/{}-2d/unbiased", set.id),
            .statement = fmt::format("The mean of e^(x+y) over six {} points has the expectation (e − 1)².", set.id),
            .source = set.source,
            .kind = Kind::mean,
            .trial = {is_unbiased, set.generate, std::move(defective)},
        });
    }
}

}  // namespace

void add_points_sets(Catalogue& catalogue) {
    add_uniform_1d(catalogue);
    add_uniform_2d(catalogue);
    add_unbiased(catalogue);
}

}  // namespace plumb::suites
