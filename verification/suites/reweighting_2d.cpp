// Sample weights by Voronoi cells in the unit square. Biases of mutants were measured with 4·10^4 samples or more,
// those that g predicts computed; delta lies at a half to a quarter of the smallest.
#include <numbers>

#include "analytic/disk_rectangle.h"
#include "analytic/disk_rectangle_exact.h"
#include "analytic/disk_rectangle_hard_cases.h"
#include "estimators/cell_weight_2d.h"
#include "estimators/halton.h"
#include "estimators/random_shift.h"
#include "estimators/reweighting_2d.h"
#include "estimators/stratified.h"
#include "estimators/tent.h"
#include "estimators/voronoi_2d.h"
#include "estimators/voronoi_brute_force.h"
#include "estimators/voronoi_hard_sets.h"
#include "verification/deterministic.h"
#include "verification/mean.h"
#include "verification/rate.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

using Samples = std::vector<Point<2>>;
using Weigh = std::function<std::vector<double>(std::span<const Point<2>>)>;

// The integrand of most claims: not linear, not periodic, its normal derivative nowhere 0 on the boundary.
double exp_sum(const Point<2>& x) {
    return std::exp(x[0] + x[1]);
}
const double exp_sum_integral = std::pow(std::expm1(1.0), 2);
const Interval exp_sum_bounds{1, std::exp(2.0)};  // of every weighted sum, too, whose weights sum to 1

double one(const Point<2>&) {
    return 1;
}

/// One weighted sum of n independent samples.
Draw weighted(const Function<2>& f, std::uint64_t n, const Weigh& weigh) {
    return [=](RandomStream& random) {
        const Samples x = independent_points<2>(n, random);
        return weighted_sum(f, x, weigh(x)).value;
    };
}

// ---- wrong cells, for mutants

/// Cells of the samples among those copies shifted by (i,j), |i|, |j| ≤ 1, that `present` keeps, inside [−1,2]².
template <class Present>
std::vector<double> cells_among_copies(std::span<const Point<2>> samples, Present present) {
    Samples all;
    for (const int i : {0, -1, 1})
        for (const int j : {0, -1, 1})
            if (present(i, j))
                for (const Point<2>& x : samples) all.push_back({(x[0] + 1 + i) / 3, (x[1] + 1 + j) / 3});
    std::vector<double> areas = voronoi_areas(all);
    areas.resize(samples.size());
    for (double& area : areas) area *= 9;
    return areas;
}

std::vector<double> copies_missing_on_the_left(std::span<const Point<2>> samples) {
    return cells_among_copies(samples, [](int i, int) { return i >= 0; });
}

std::vector<double> diagonal_copies_missing(std::span<const Point<2>> samples) {
    return cells_among_copies(samples, [](int i, int j) { return i == 0 || j == 0; });
}

std::vector<double> not_clipped(std::span<const Point<2>> samples) {
    return cells_among_copies(samples, [](int i, int j) { return i == 0 && j == 0; });
}

std::vector<double> coincident_counted_fully(std::span<const Point<2>> samples) {
    std::map<Point<2>, int> count;
    for (const Point<2>& x : samples) ++count[x];
    std::vector<double> areas = voronoi_areas(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) areas[i] *= count[samples[i]];
    return areas;
}

// ---- areas

std::vector<HardSet> corpus(const Run& run, std::size_t largest) {
    std::vector<HardSet> sets;
    for (HardSet& set : voronoi_hard_sets())
        if (set.samples.size() <= largest) sets.push_back(std::move(set));
    for (std::uint64_t i = 0; i < 50; ++i) {
        RandomStream random = run.random(i);
        sets.push_back({fmt::format("{} random samples", i + 1), independent_points<2>(i + 1, random)});
    }
    return sets;
}

Check weights_sum_to_1(const Weigh& weigh) {
    return [=](const Run& run) {
        std::vector<BoundedCase> cases;
        for (const HardSet& set : corpus(run, 200000)) {
            const std::vector<double> weights = weigh(set.samples);
            double sum = 0, smallest = 0;
            for (const double w : weights) sum += w, smallest = std::min(smallest, w);
            cases.push_back({set.name, std::abs(sum - 1) + (smallest < 0 ? 1 : 0)});
        }
        return within_bound(cases, 1e-12, "absolute");
    };
}

Check areas_agree(const Weigh& weigh, const Weigh& reference, bool only_separated) {
    return [=](const Run& run) {
        std::vector<BoundedCase> cases;
        for (const HardSet& set : corpus(run, 300)) {
            if (only_separated && !set.separated) continue;
            const std::vector<double> found = weigh(set.samples), truth = reference(set.samples);
            double worst = 0;
            for (std::size_t i = 0; i < truth.size(); ++i) worst = std::max(worst, std::abs(found[i] - truth[i]));
            cases.push_back({set.name, worst});
        }
        return within_bound(cases, 1e-12, "absolute");
    };
}

void add_areas(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-voronoi/sum-to-1",
        .statement = "Areas of clipped Voronoi cells are non-negative and sum to 1 within 1e-12, on random and on "
                     "degenerate samples.",
        .source = "ours, estimators/voronoi_2d.h",
        .kind = Kind::bounded,
        .check = weights_sum_to_1(voronoi_areas),
        .mutants = {{"not-clipped", "boundary cells reach out of the square", weights_sum_to_1(not_clipped)},
                    {"coincident-counted-fully", "each of several coincident samples gets the whole cell",
                     weights_sum_to_1(coincident_counted_fully)}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus/sum-to-1",
        .statement = "Areas of Voronoi cells on the torus are non-negative and sum to 1 within 1e-12, on random and on "
                     "degenerate samples.",
        .source = "ours, estimators/voronoi_2d.h",
        .kind = Kind::bounded,
        .check = weights_sum_to_1(voronoi_areas_periodic),
        .mutants = {{"copies-missing-on-the-left", "periodic copies are added on three sides only",
                     weights_sum_to_1(copies_missing_on_the_left)}},
    });
    catalogue.add({
        .id = "reweighting/2d-voronoi/areas",
        .statement = "Clipped Voronoi areas equal the square cut by every bisector, within 1e-12.",
        .source = "definition of the cell, estimators/voronoi_brute_force.h",
        .kind = Kind::bounded,
        .check = areas_agree(voronoi_areas, brute_force_voronoi_areas, false),
        .mutants = {{"torus", "cells on the torus",
                     areas_agree(voronoi_areas_periodic, brute_force_voronoi_areas, true)}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus/areas",
        .statement =
            "Voronoi areas on the torus equal the square around a sample cut by every bisector with every copy, "
            "within 1e-12.",
        .source = "definition of the cell, estimators/voronoi_brute_force.h",
        .kind = Kind::bounded,
        .check = areas_agree(voronoi_areas_periodic, brute_force_voronoi_areas_periodic, true),
        .mutants = {{"diagonal-copies-missing", "periodic copies only to the left, right, below and above",
                     areas_agree(diagonal_copies_missing, brute_force_voronoi_areas_periodic, true)},
                    {"clipped", "clipped cells called periodic",
                     areas_agree(voronoi_areas, brute_force_voronoi_areas_periodic, true)}},
    });
}

// ---- unbiased on the torus

Check unbiased(const Function<2>& f, std::uint64_t n, const Weigh& weigh, double delta) {
    return [draw = weighted(f, n, weigh), delta](const Run& run) {
        return mean_is(draw, {.reference = exp_sum_integral, .delta = delta, .bounds = exp_sum_bounds}, run);
    };
}

double tented(const Point<2>& u) {
    return exp_sum(tent(u));
}
double sine_tented(const Point<2>& u) {
    const auto phi = [](double v) { return (1 - std::cos(2 * std::numbers::pi * v)) / 2; };
    return exp_sum({phi(u[0]), phi(u[1])});
}
double half_tented(const Point<2>& u) {
    return exp_sum({std::min(u[0], 1 - u[0]), std::min(u[1], 1 - u[1])});
}

/// The area of the cell of a sample at a fixed place among n − 1 uniform ones.
Check mean_cell_is_one_in_n(const Weigh& weigh) {
    return [=](const Run& run) {
        const auto cell = [=](RandomStream& random) {
            Samples x = independent_points<2>(4, random);
            x[0] = {0.1, 0.3};
            return weigh(x)[0];
        };
        return mean_is(cell, {.reference = 0.25, .delta = 0.01, .bounds = {0, 1}}, run);
    };
}

using Shift = Samples (*)(Samples, RandomStream&);

Samples first_axis_shifted(Samples points, RandomStream& random) {
    const double shift = random.uniform();
    for (Point<2>& x : points) x[0] = std::fmod(x[0] + shift, 1.0);
    return points;
}

Check unbiased_after_shift(Shift shift, const Weigh& weigh) {
    return [=](const Run& run) {
        const auto draw = [=](RandomStream& random) {
            const Samples x = shift({{0.1, 0.1}, {0.15, 0.1}, {0.1, 0.3}, {0.6, 0.65}}, random);
            return weighted_sum(exp_sum, x, weigh(x)).value;
        };
        return mean_is(draw, {.reference = exp_sum_integral, .delta = 0.02, .bounds = exp_sum_bounds}, run);
    };
}

void add_torus(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-torus/unbiased",
        .statement =
            "Torus weights of 4 independent samples integrate e^(x+y) without bias, though it is not periodic.",
        .source = "ours, estimators/reweighting_2d.h; the thesis, A.2, calls the periodic scheme biased",
        .kind = Kind::mean,
        .check = unbiased(exp_sum, 4, voronoi_areas_periodic, 0.014),
        .mutants = {{"clipped", "clipped cells called unbiased: bias -0.042",
                     unbiased(exp_sum, 4, voronoi_areas, 0.014)},
                    {"copies-missing-on-the-left", "periodic copies are added on three sides only",
                     unbiased(exp_sum, 4, copies_missing_on_the_left, 0.014)}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus/mean-cell",
        .statement = "The cell of a sample at a fixed place on the torus, among 3 uniform ones, has the mean area 1/4.",
        .source = "ours, estimators/reweighting_2d.h",
        .kind = Kind::mean,
        .check = mean_cell_is_one_in_n(voronoi_areas_periodic),
        .mutants = {{"clipped", "clipped cells: bias -0.032", mean_cell_is_one_in_n(voronoi_areas)},
                    {"diagonal-copies-missing", "periodic copies only to the left, right, below and above",
                     mean_cell_is_one_in_n(diagonal_copies_missing)}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus-tent/unbiased",
        .statement = "Torus weights of 4 independent samples, the integrand folded by the tent map, integrate e^(x+y) "
                     "without bias.",
        .source = "ours, estimators/reweighting_2d.h",
        .kind = Kind::mean,
        .check = unbiased(tented, 4, voronoi_areas_periodic, 0.04),
        .mutants = {{"without-factor", "the tent without its factor 2 covers a quarter of the square: bias -1.27",
                     unbiased(half_tented, 4, voronoi_areas_periodic, 0.04)},
                    {"sine", "a smooth fold in place of the tent, without its Jacobian: bias +0.122",
                     unbiased(sine_tented, 4, voronoi_areas_periodic, 0.04)},
                    {"clipped", "clipped cells under the tent: bias +0.31", unbiased(tented, 4, voronoi_areas, 0.04)}},
    });
    catalogue.add({
        .id = "reweighting/2d-shifted-torus/unbiased",
        .statement = "Any 4 points, moved by one uniform vector and weighted by their cells on the torus, integrate "
                     "e^(x+y) without bias.",
        .source = "ours, estimators/reweighting_2d.h",
        .kind = Kind::mean,
        .check = unbiased_after_shift(random_shift<2>, voronoi_areas_periodic),
        .mutants = {{"no-shift", "the points stay where they are",
                     unbiased_after_shift([](Samples x, RandomStream&) { return x; }, voronoi_areas_periodic)},
                    {"one-axis", "the points are shifted along the first axis only",
                     unbiased_after_shift(first_axis_shifted, voronoi_areas_periodic)},
                    {"clipped", "clipped cells after the shift: bias -0.058",
                     unbiased_after_shift(random_shift<2>, voronoi_areas)}},
    });
}

// ---- the expected cell g

const CellWeightTable2D& g_of_2() {
    static const CellWeightTable2D g(2, 17);
    return g;
}
const CellWeightTable2D& g_of_3() {
    static const CellWeightTable2D g(3, 17);
    return g;
}
const CellWeightTable2D& g_of_4() {
    static const CellWeightTable2D g(4, 17);
    return g;
}

/// [thesis, eq. 4.6], for one axis.
double g_1d(double n, double x) {
    return ((n - n * x - x) * std::pow(x, n - 1) + (n * x + x - 1) * std::pow(1 - x, n - 1) + 2) / 2;
}
Function<2> product_of_1d(double n) {
    return [n](const Point<2>& x) { return g_1d(n, x[0]) * g_1d(n, x[1]); };
}

double integral_by_midpoints(const Function<2>& f) {
    constexpr int side = 200;
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) sum += f({(i + 0.5) / side, (j + 0.5) / side});
    return sum / (side * side);
}

Check g_integrates_to_1(double exponent_of_4) {
    return [=](const Run&) {
        const BallMeasure ball{[=](const Point<2>& y, double radius) {
            return -std::expm1(exponent_of_4 / 3 * std::log1p(-disk_rectangle_area(y, radius)));
        }};
        const double integral = integral_by_midpoints(CellWeightTable2D(4, ball, 13));
        return within_bound({{fmt::format("the integral of g is {}", integral), std::abs(integral - 1)}}, 1e-4,
                            "absolute");
    };
}

Check clipped_mean_is(const Function<2>& g) {
    return [=](const Run& run) {
        const double predicted = integral_by_midpoints([&](const Point<2>& x) { return g(x) * exp_sum(x); });
        const MeanClaim claim{.reference = predicted, .delta = 0.014, .epsilon = 3e-4, .bounds = exp_sum_bounds};
        return mean_is(weighted(exp_sum, 4, voronoi_areas), claim, run);
    };
}

Weigh divided_by(const Function<2>& g) {
    return [=](std::span<const Point<2>> x) { return reweighted_weights_2d(x, g, one); };
}

std::vector<double> normalised(std::span<const Point<2>> x) {
    std::vector<double> weights = reweighted_weights_2d(x, g_of_2(), one);
    const double sum = weights[0] + weights[1];
    for (double& w : weights) w /= sum;
    return weights;
}

Check reweighted_unbiased(const Weigh& weigh) {
    return [=](const Run& run) {
        // weights ≥ 0 with a sum of at most 1/min g = 1/0.4532…; epsilon is the table's error over min g, times the
        // integral
        const MeanClaim claim{.reference = exp_sum_integral,
                              .delta = 0.0085,
                              .epsilon = 1.2e-3,
                              .bounds = {0, exp_sum_bounds.high / 0.45}};
        return mean_is(weighted(exp_sum, 2, weigh), claim, run);
    };
}

// p = 3/2 on the left half of the square, 1/2 on the right.
double two_piece_pdf(const Point<2>& x) {
    return x[0] < 0.5 ? 1.5 : 0.5;
}
BallMeasure two_piece_ball() {
    return {[](const Point<2>& centre, double radius) {
                return 1.5 * disk_rectangle_area(centre, radius, {{0, 0}, {0.5, 1}}) +
                       0.5 * disk_rectangle_area(centre, radius, {{0.5, 0}, {1, 1}});
            },
            {{{0, 0.5, 1}, {0, 1}}}};
}
Point<2> two_piece_sample(const Point<2>& u) {
    return {u[0] < 0.75 ? u[0] / 1.5 : 2 * u[0] - 1, u[1]};
}

const CellWeightTable2D& two_piece_g() {
    static const CellWeightTable2D g(3, two_piece_ball(), 13);
    return g;
}

Check density_unbiased(const Function<2>& g, const Function<2>& pdf, double largest_weight) {
    return [=](const Run& run) {
        const auto draw = [=](RandomStream& random) {
            Samples x = independent_points<2>(3, random);
            for (Point<2>& u : x) u = two_piece_sample(u);
            return weighted_sum(exp_sum, x, reweighted_weights_2d(x, g, pdf)).value;
        };
        const MeanClaim claim{.reference = exp_sum_integral,
                              .delta = 0.05,
                              .epsilon = 1.5e-3,
                              .bounds = {0, exp_sum_bounds.high * largest_weight}};
        return mean_is(draw, claim, run);
    };
}

void add_expected_cells(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-general-g/integrates-to-1",
        .statement = "The tabulated g of 4 uniform samples in the square integrates to 1, because their cells fill it.",
        .source = "ours, estimators/cell_weight_2d.h",
        .kind = Kind::bounded,
        .check = g_integrates_to_1(3),
        .mutants = {{"exponent-n", "the ball must miss N samples instead of N-1", g_integrates_to_1(4)}},
    });
    catalogue.add({
        .id = "reweighting/2d-voronoi/biased-by-g",
        .statement = "Clipped Voronoi weights of 4 independent samples estimate the integral of g f, not of f.",
        .source = "thesis, eq. 4.5, carried to two dimensions in estimators/cell_weight_2d.h",
        .kind = Kind::mean,
        .check = clipped_mean_is(g_of_4()),
        .mutants = {{"unbiased", "the consistent estimator called unbiased: 0.042 too high", clipped_mean_is(one)}},
    });
    catalogue.add({
        .id = "reweighting/2d-general-g/unbiased",
        .statement = "Clipped Voronoi weights over g integrate e^(x+y) without bias from 2 independent samples.",
        .source = "ours, estimators/cell_weight_2d.h; in one dimension thesis, eq. 4.8",
        .kind = Kind::mean,
        .check = reweighted_unbiased(divided_by(g_of_2())),
        .mutants = {{"normalised", "|V|/g scaled to sum to 1: bias -0.021", reweighted_unbiased(normalised)},
                    {"n-minus-1", "g of one sample fewer, which is 1: bias -0.035", reweighted_unbiased(voronoi_areas)},
                    {"product", "g as the product of one-dimensional ones: bias +0.13",
                     reweighted_unbiased(divided_by(product_of_1d(2)))}},
    });
    catalogue.add({
        .id = "reweighting/2d-general-g/unbiased-density",
        .statement =
            "Clipped Voronoi weights over g p integrate e^(x+y) without bias from 3 samples of a density p that "
            "is not uniform.",
        .source = "ours, estimators/cell_weight_2d.h",
        .kind = Kind::mean,
        .check = density_unbiased(two_piece_g(), two_piece_pdf, 7),
        .mutants = {{"uniform-g", "g of uniform samples: 4.7 % too bright",
                     density_unbiased(g_of_3(), two_piece_pdf, 7)},
                    {"without-p", "not divided by the density", density_unbiased(two_piece_g(), one, 4)}},
    });
}

// ---- rates

struct RateSubject {
    std::string estimator, integrand;
    Function<2> f;
    double truth;
};

Check falls_as(const RateSubject& subject, const Weigh& weigh, std::vector<std::uint64_t> n, std::uint64_t replicates,
               double exponent) {
    return [=](const Run& run) {
        const Replicate replicate = [=](std::uint64_t count, RandomStream& random) {
            const Samples x = independent_points<2>(count, random);
            return weighted_sum(subject.f, x, weigh(x));
        };
        return rate_is(replicate, {subject.estimator, subject.integrand, subject.truth, n, replicates},
                       {exponent - 0.2, exponent + 0.2}, run);
    };
}

std::vector<double> equal_weights(std::span<const Point<2>> samples) {
    return std::vector<double>(samples.size(), 1 / static_cast<double>(samples.size()));
}

double plane(const Point<2>& x) {
    return x[0] + 2 * x[1];
}
double wave(const Point<2>& x) {
    return 1 + (std::cos(2 * std::numbers::pi * x[0]) + std::sin(2 * std::numbers::pi * x[1])) / 2;
}

void add_rates(Catalogue& catalogue) {
    const std::vector<std::uint64_t> small{16, 32, 64, 128, 256}, middle{64, 128, 256, 512},
        large{256, 512, 1024, 2048};
    const RateSubject torus{"torus", "e^(x+y)", exp_sum, exp_sum_integral};
    catalogue.add({
        .id = "reweighting/2d-torus/rate",
        .statement = "The MSE of torus weights falls as N^-1.5 where the periodic extension jumps.",
        .source = "ours: -1 - (1 + 2k)/D, estimators/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .check = falls_as(torus, voronoi_areas_periodic, small, 1500, -1.5),
        .mutants = {{"equal-weights", "weights 1/N: -1", falls_as(torus, equal_weights, small, 1500, -1.5)},
                    {"clipped", "clipped cells: -2 and steeper", falls_as(torus, voronoi_areas, small, 1500, -1.5)}},
    });
    const RateSubject tent_plane{"torus-tent", "x+2y", [](const Point<2>& u) { return plane(tent(u)); }, 1.5};
    const RateSubject one_axis{"torus-tent", "x+2y", [](const Point<2>& u) { return plane({tent(u[0]), u[1]}); }, 1.5};
    catalogue.add({
        .id = "reweighting/2d-torus-tent/rate",
        .statement = "The MSE of torus weights under the tent map falls as N^-2.5: the tent leaves a kink.",
        .source = "ours: -1 - (1 + 2k)/D, estimators/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .check = falls_as(tent_plane, voronoi_areas_periodic, middle, 2000, -2.5),
        .mutants = {{"one-axis", "the tent on one axis leaves the jump of the other: -1.5",
                     falls_as(one_axis, voronoi_areas_periodic, middle, 2000, -2.5)}},
    });
    const RateSubject tent_exp{"torus-tent", "e^(x+y)", tented, exp_sum_integral};
    catalogue.add({
        .id = "reweighting/2d-torus-tent/rate-exp",
        .statement = "The MSE of torus weights under the tent map falls as N^-2.5 for e^(x+y).",
        .source = "ours: -1 - (1 + 2k)/D, estimators/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .check = falls_as(tent_exp, voronoi_areas_periodic, large, 2000, -2.5),
        .mutants = {{"no-tent", "without the tent: -1.5", falls_as(torus, voronoi_areas_periodic, large, 2000, -2.5)}},
        .sizes = Sizes::full_only,
    });
    const RateSubject smooth{"torus", "1+(cos 2πx + sin 2πy)/2", wave, 1};
    catalogue.add({
        .id = "reweighting/2d-torus/rate-smooth",
        .statement = "The MSE of torus weights falls as N^-3 for an integrand that is smooth on the torus.",
        .source = "ours: -1 - 4/D, estimators/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .check = falls_as(smooth, voronoi_areas_periodic, large, 2000, -3),
        .mutants = {{"clipped", "clipped cells: -2.5 and slower", falls_as(smooth, voronoi_areas, large, 2000, -3)}},
        .sizes = Sizes::full_only,
    });
}

// ---- the area of a disk in a rectangle

/// The same area with arc sines, whose sum cancels against π/2 where the disk is thin in the rectangle.
double quarter_by_arc_sines(double w, double h, double r) {
    w = std::min(w, r);
    h = std::min(h, r);
    if (w * w + h * h <= r * r) return w * h;
    return (w * std::sqrt(r * r - w * w) + h * std::sqrt(r * r - h * h) +
            r * r * (std::asin(w / r) + std::asin(h / r) - std::numbers::pi / 2)) /
           2;
}
double disk_area_by_arc_sines(const Point<2>& c, double r, const Rectangle& box) {
    double sum = 0;
    for (const double w : {c[0] - box.low[0], box.high[0] - c[0]})
        for (const double h : {c[1] - box.low[1], box.high[1] - c[1]}) sum += quarter_by_arc_sines(w, h, r);
    return sum;
}

Check disk_area_is_stable(double (*area)(const Point<2>&, double, const Rectangle&)) {
    return [=](const Run&) {
        std::vector<BoundedCase> cases;
        for (const DiskCase& c : disk_rectangle_hard_cases()) {
            const double truth = disk_rectangle_area_by_chords(c.centre, c.radius, c.rectangle);
            cases.push_back({c.name, ulp_error(area(c.centre, c.radius, c.rectangle), truth), c.radius});
        }
        return stable(cases, 8, "area of a disk in a rectangle", "radius");
    };
}

void add_disk(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-disk/stable",
        .statement = "The area of a disk in a rectangle that holds its centre is right within 8 ulp.",
        .source = "ours, analytic/disk_rectangle.cpp",
        .kind = Kind::bounded,
        .check = disk_area_is_stable(disk_rectangle_area),
        .mutants = {{"arc-sines", "the textbook formula with arc sines", disk_area_is_stable(disk_area_by_arc_sines)}},
    });
}

}  // namespace

void add_reweighting_2d_claims(Catalogue& catalogue) {
    add_areas(catalogue);
    add_torus(catalogue);
    add_expected_cells(catalogue);
    add_rates(catalogue);
    add_disk(catalogue);
}

}  // namespace plumb
