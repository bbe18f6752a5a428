// Strata and nets: exact, over every stratum and elementary interval of all small sets.
#include <algorithm>
#include <cmath>

#include "estimators/points/halton.h"
#include "estimators/points/latin_hypercube.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/random_shift.h"
#include "estimators/points/sobol.h"
#include "estimators/points/strata.h"
#include "estimators/points/stratified.h"
#include "estimators/points/zero_two.h"
#include "verification/claim.h"
#include "verification/suites/points/defective_point_sets.h"
#include "verification/suites/tally.h"

namespace plumb::suites {
namespace {

bool inside(const Point<2>& p) {
    return 0 <= p[0] && p[0] < 1 && 0 <= p[1] && p[1] < 1;
}

/// Whether each of the columns × rows = n cells of the cube holds exactly one of the n points.
bool one_in_each(std::span<const Point<2>> points, std::uint64_t columns, std::uint64_t rows) {
    std::vector<bool> taken(columns * rows);
    if (points.size() != taken.size() || !std::ranges::all_of(points, inside)) return false;
    for (const auto& [x, y] : points) {
        const std::uint64_t cell = stratum_of(x, columns) * rows + stratum_of(y, rows);
        if (taken[cell]) return false;
        taken[cell] = true;
    }
    return true;
}

/// Whether the set of n points fills the columns, the rows and the cells that it stratifies.
struct Stratified {
    bool columns, rows, cells;
};

Verdict fills_strata(const Generate<2>& generate, const Stratified& claimed, const Run& run) {
    Tally tally;
    for (std::uint64_t n = 1; n <= 64; ++n)
        for (std::uint64_t repeat = 0; repeat < 8; ++repeat) {
            RandomStream random = run.random(n * 8 + repeat);
            const auto points = generate(n, random);
            const Grid grid = grid_of(n);
            const auto expect = [&](bool wanted, std::uint64_t columns, std::uint64_t rows) {
                if (!wanted) return;
                tally.expect(one_in_each(points, columns, rows), [&] {
                    return fmt::format("n = {}: a cell of the {} × {} grid does not hold one point", n, columns, rows);
                });
            };
            expect(claimed.columns, n, 1);
            expect(claimed.rows, 1, n);
            expect(claimed.cells, grid.columns, grid.rows);
        }
    return tally.verdict("stratifications of random sets hold one point a stratum");
}

Generate<2> lifted(const Generate<1>& generate) {
    return [generate](std::uint64_t n, RandomStream& random) {
        std::vector<Point<2>> points;
        for (const auto& [x] : generate(n, random)) points.push_back({x, 0});
        return points;
    };
}

/// Stratified, but the jitter reaches a quarter into the next stratum (on the torus).
Generate<1> wide_jitter() {
    return [](std::uint64_t n, RandomStream& random) {
        std::vector<Point<1>> points(n);
        for (std::uint64_t i = 0; i < n; ++i) {
            const double x = (static_cast<double>(i) + 1.25 * random.uniform()) / static_cast<double>(n);
            points[i] = {x - std::floor(x)};
        }
        return points;
    };
}

std::vector<Point<2>> independent_in_columns(std::uint64_t n, RandomStream& random) {
    std::vector<Point<2>> points;
    for (const auto& [x] : stratified_1d(n, random)) points.push_back({x, random.uniform()});
    return points;
}

void add_strata(Catalogue& catalogue) {
    catalogue.add({
        .id = "points/stratified-1d/strata",
        .statement = "Each of n equal intervals holds exactly one stratified point, n = 1 … 64.",
        .source = "[Haber 1966]; estimators/points/stratified.cpp",
        .trial = {[](const Generate<2>& generate, const Run& run) {
                      return fills_strata(generate, {true, false, false}, run);
                  },
                  lifted(stratified_1d),
                  {{"jitter-into-the-next", "The jitter spans five quarters of a stratum.", lifted(wide_jitter())}}},
    });
    catalogue.add({
        .id = "points/stratified-2d/strata",
        .statement =
            "Each cell of the grid of n = columns × rows cells holds exactly one stratified point, n = 1 … 64.",
        .source = "[Haber 1966]; estimators/points/stratified.cpp",
        .trial = {[](const Generate<2>& generate, const Run& run) {
                      return fills_strata(generate, {false, false, true}, run);
                  },
                  stratified_2d,
                  {{"columns-only", "The points are stratified along x only.", independent_in_columns}}},
    });
    catalogue.add({
        .id = "points/latin-hypercube-2d/projections",
        .statement = "Each of n columns and each of n rows holds exactly one point of a Latin hypercube, n = 1 … 64.",
        .source = "[McKay, Beckman & Conover 1979]",
        .trial = {[](const Generate<2>& generate, const Run& run) {
                      return fills_strata(generate, {true, true, false}, run);
                  },
                  latin_hypercube_2d,
                  {{"rows-with-repetition", "Rows are drawn independently, not by a permutation.",
                    latin_hypercube_with_repeated_rows}}},
    });
    catalogue.add({
        .id = "points/cmj-2d/strata",
        .statement = "Each grid cell, each of n columns and each of n rows holds exactly one correlated multi-jittered "
                     "point, n = 1 … 64.",
        .source = "[Kensler 2013]",
        .trial = {[](const Generate<2>& generate, const Run& run) {
                      return fills_strata(generate, {true, true, true}, run);
                  },
                  correlated_multi_jittered_2d,
                  {{"permuted-by-own-index",
                    "The place within a column is set by the column instead of the row, and vice versa.",
                    multi_jittered_by_own_index},
                   {"stratified-only", "Jittered in the cells, not multi-jittered.", stratified_2d}}},
    });
}

/// Whether each elementary interval of area 1/n, n a power of two, holds exactly one of these n points.
bool is_net(std::span<const Point<2>> points) {
    for (std::uint64_t columns = 1; columns <= points.size(); columns *= 2)
        if (!one_in_each(points, columns, points.size() / columns)) return false;
    return true;
}

/// The first 2^k points, k ≤ 10, of several sets.
Verdict first_points_are_nets(const Generate<2>& generate, std::uint64_t repeats, const Run& run) {
    Tally tally;
    for (std::uint64_t k = 0; k <= 10; ++k)
        for (std::uint64_t repeat = 0; repeat < repeats; ++repeat) {
            RandomStream random = run.random(k * repeats + repeat);
            tally.expect(is_net(generate(std::uint64_t{1} << k, random)), [&] {
                return fmt::format("an elementary interval of area 2^-{} does not hold one point", k);
            });
        }
    return tally.verdict("sets of 2^k points, k ≤ 10, hold one point in each elementary interval of area 2^-k");
}

/// Every aligned run of 2^k points among the first 2^10.
Verdict is_sequence(std::vector<Point<2>> (*points)(std::uint64_t)) {
    Tally tally;
    const auto all = points(1 << 10);
    for (std::size_t length = 1; length <= all.size(); length *= 2)
        for (std::size_t begin = 0; begin < all.size(); begin += length)
            tally.expect(is_net(std::span(all).subspan(begin, length)),
                         [&] { return fmt::format("points {} … {} are no (0,m,2)-net", begin, begin + length - 1); });
    return tally.verdict("aligned runs of 2^k points among the first 1024 are (0,k,2)-nets");
}

std::vector<Point<2>> same_axis_twice(std::uint64_t n) {
    std::vector<Point<2>> points;
    for (const auto& [x] : halton_1d(n)) points.push_back({x, x});
    return points;
}

Generate<2> fixed(std::vector<Point<2>> (*points)(std::uint64_t)) {
    return [points](std::uint64_t n, RandomStream&) { return points(n); };
}

/// The third digit of every point flipped by a coin of its own, instead of the coin of its first two digits.
std::vector<Point<2>> coins_of_their_own(std::uint64_t n, RandomStream& random) {
    auto digits = zero_two_digits(n);
    for (BinaryPoint<2>& point : digits)
        for (std::uint64_t& x : point) x ^= (random.bits() & 1) << 61;
    return to_points<2>(digits);
}

std::vector<Point<2>> shifted_zero_two(std::uint64_t n, RandomStream& random) {
    return random_shift<2>(zero_two(n), random);
}

void add_nets(Catalogue& catalogue) {
    catalogue.add({
        .id = "points/sobol-2d/elementary-intervals",
        .statement = "Every aligned run of 2^k among the first 1024 points of Sobol's sequence holds one point in each "
                     "elementary interval of "
                     "area 2^-k, on the first two axes.",
        .source = "[Sobol' 1967]; estimators/points/sobol.h",
        .trial = {is_sequence,
                  sobol_2d,
                  {{"first-point-dropped", "The sequence starts at its second point, as Boost.Random's does.",
                    sobol_without_origin}}},
    });
    catalogue.add({
        .id = "points/zero-two-2d/elementary-intervals",
        .statement = "Every aligned run of 2^k among the first 1024 points of the (0,2)-sequence holds one point in "
                     "each elementary interval "
                     "of area 2^-k.",
        .source = "[Kollig & Keller 2002]; estimators/points/zero_two.cpp",
        .trial = {is_sequence,
                  zero_two,
                  {{"same-matrix-twice", "Both axes are van der Corput's sequence.", same_axis_twice},
                   {"halton", "Halton's sequence, whose second axis is in base 3.", halton_2d}}},
    });
    const auto add_scrambled = [&](const std::string& id,
                                   std::vector<Point<2>> (*generate)(std::uint64_t, RandomStream&),
                                   const std::string& source) {
        catalogue.add({
            .id = "points/" + id + "-2d/elementary-intervals",
            .statement = "Scrambling keeps the first 2^k points a net: one in each elementary interval of area 2^-k.",
            .source = source,
            .trial = {[](const Generate<2>& generate, const Run& run) {
                          return first_points_are_nets(generate, 8, run);
                      },
                      generate,
                      {{"coins-of-their-own", "A digit of each point is flipped by a coin that no other point shares.",
                        coins_of_their_own},
                       {"random-shift", "The net is shifted on the torus, which keeps distances but not nets.",
                        shifted_zero_two}}},
        });
    };
    add_scrambled("sobol-owen", owen_sobol_2d, "[Owen 1995]");
    add_scrambled("zero-two-owen", owen_zero_two, "[Owen 1995]");
    add_scrambled("zero-two-xor", xor_zero_two, "[Kollig & Keller 2002]");
    catalogue.add({
        .id = "points/hammersley-2d/elementary-intervals",
        .statement = "2^k points of Hammersley's set hold one point in each elementary interval of area 2^-k.",
        .source = "[Hammersley 1960; Niederreiter 1992]",
        .trial = {[](const Generate<2>& generate, const Run& run) { return first_points_are_nets(generate, 1, run); },
                  fixed(hammersley_2d),
                  {{"from-one", "(i + 1)/n on the first axis: the last point leaves the square.",
                    fixed(hammersley_from_one)}}},
    });
}

Verdict halton_fills_boxes(std::vector<Point<2>> (*points)(std::uint64_t)) {
    Tally tally;
    for (std::uint64_t columns = 1; columns <= 64; columns *= 2)
        for (std::uint64_t rows = 1; rows <= 81; rows *= 3)
            tally.expect(one_in_each(points(columns * rows), columns, rows), [&] {
                return fmt::format("one of {} × {} boxes does not hold one of the first points", columns, rows);
            });
    return tally.verdict("grids of 2^a × 3^b boxes hold one of the first 2^a 3^b points a box");
}

std::vector<Point<2>> halton_in_bases_two_and_six(std::uint64_t n) {
    std::vector<Point<2>> points;
    for (std::uint32_t i = 0; i < n; ++i) points.push_back({radical_inverse(2, i), radical_inverse(6, i)});
    return points;
}

void add_halton(Catalogue& catalogue) {
    catalogue.add({
        .id = "points/halton-2d/elementary-intervals",
        .statement = "The first 2^a 3^b points of Halton's sequence lie one in each of 2^a × 3^b equal boxes.",
        .source = "[Halton 1960]; the Chinese remainder theorem",
        .trial = {halton_fills_boxes,
                  halton_2d,
                  {{"bases-not-coprime", "Bases 2 and 6.", halton_in_bases_two_and_six}}},
    });
}

}  // namespace

void add_points_structure(Catalogue& catalogue) {
    add_strata(catalogue);
    add_nets(catalogue);
    add_halton(catalogue);
}

}  // namespace plumb::suites
