// The expectation g/N of a clipped cell: what bias it gives, and how dividing by it removes the bias.
#include "analytic/disk_rectangle.h"
#include "estimators/points/stratified.h"
#include "estimators/reweighting/cell_weight_2d.h"
#include "estimators/reweighting/reweighting_2d.h"
#include "estimators/voronoi/voronoi_2d.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/reweighting/subjects_2d.h"

namespace plumb::suites {
namespace {

double one(const Point<2>&) {
    return 1;
}

// Tables are built when a check first needs them.
double g_of_2(const Point<2>& x) {
    static const CellWeightTable2D g(2, 17);
    return g(x);
}
double g_of_3(const Point<2>& x) {
    static const CellWeightTable2D g(3, 17);
    return g(x);
}
double g_of_4(const Point<2>& x) {
    static const CellWeightTable2D g(4, 17);
    return g(x);
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

Verdict g_integrates_to_1(double exponent_of_4) {
    const BallMeasure ball{[=](const Point<2>& y, double radius) {
        return -std::expm1(exponent_of_4 / 3 * std::log1p(-disk_rectangle_area(y, radius)));
    }};
    const double integral = integral_by_midpoints(CellWeightTable2D(4, ball, 13));
    return within_bound({{fmt::format("the integral of g is {}", integral), std::abs(integral - 1)}}, 1e-4, "absolute");
}

Verdict clipped_mean_is(const Function<2>& g, const Run& run) {
    const double predicted = integral_by_midpoints([&](const Point<2>& x) { return g(x) * exp_sum(x); });
    const MeanClaim claim{.reference = predicted, .delta = 0.014, .epsilon = 3e-4, .bounds = exp_sum_bounds};
    return mean_is(weighted(exp_sum, 4, voronoi_areas), claim, run);
}

Weigh divided_by(const Function<2>& g) {
    return [=](std::span<const Point<2>> x) { return reweighted_weights_2d(x, g, one); };
}

std::vector<double> normalised(std::span<const Point<2>> x) {
    std::vector<double> weights = reweighted_weights_2d(x, g_of_2, one);
    const double sum = weights[0] + weights[1];
    for (double& w : weights) w /= sum;
    return weights;
}

Verdict reweighted_unbiased(const Weigh& weigh, const Run& run) {
    // weights ≥ 0 with a sum of at most 1/min g = 1/0.4532…; epsilon is the table's error over min g, times the
    // integral
    const MeanClaim claim{
        .reference = exp_sum_integral, .delta = 0.0085, .epsilon = 1.2e-3, .bounds = {0, exp_sum_bounds.high / 0.45}};
    return mean_is(weighted(exp_sum, 2, weigh), claim, run);
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

double two_piece_g(const Point<2>& x) {
    static const CellWeightTable2D g(3, two_piece_ball(), 13);
    return g(x);
}

// Weights |V|/(g p); their sum is at most `largest_weight`.
struct Division {
    Function<2> g, pdf;
    double largest_weight;
};

Verdict density_unbiased(const Division& by, const Run& run) {
    const auto draw = [=](RandomStream& random) {
        Samples x = independent_points<2>(3, random);
        for (Point<2>& u : x) u = two_piece_sample(u);
        return weighted_sum(exp_sum, x, reweighted_weights_2d(x, by.g, by.pdf)).value;
    };
    const MeanClaim claim{.reference = exp_sum_integral,
                          .delta = 0.05,
                          .epsilon = 1.5e-3,
                          .bounds = {0, exp_sum_bounds.high * by.largest_weight}};
    return mean_is(draw, claim, run);
}

}  // namespace

void add_reweighting_expected_cells_2d(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-general-g/integrates-to-1",
        .statement = "The tabulated g of 4 uniform samples in the square integrates to 1, because their cells fill it.",
        .source = "ours, estimators/reweighting/cell_weight_2d.h",
        .kind = Kind::bounded,
        .trial = {g_integrates_to_1, 3, {{"exponent-n", "the ball must miss N samples instead of N-1", 4}}},
    });
    catalogue.add({
        .id = "reweighting/2d-voronoi/biased-by-g",
        .statement = "Clipped Voronoi weights of 4 independent samples estimate the integral of g f, not of f.",
        .source = "[thesis, eq. 4.5], carried to two dimensions in estimators/reweighting/cell_weight_2d.h",
        .kind = Kind::mean,
        .trial = {clipped_mean_is,
                  g_of_4,
                  {{"unbiased", "the consistent estimator called unbiased: 0.042 too high", one}}},
    });
    catalogue.add({
        .id = "reweighting/2d-general-g/unbiased",
        .statement = "Clipped Voronoi weights over g integrate e^(x+y) without bias from 2 independent samples.",
        .source = "ours, estimators/reweighting/cell_weight_2d.h; in one dimension [thesis, eq. 4.8]",
        .kind = Kind::mean,
        .trial = {reweighted_unbiased,
                  divided_by(g_of_2),
                  {{"normalised", "|V|/g scaled to sum to 1: bias -0.021", normalised},
                   {"n-minus-1", "g of one sample fewer, which is 1: bias -0.035", voronoi_areas},
                   {"product", "g as the product of one-dimensional ones: bias +0.13", divided_by(product_of_1d(2))}}},
    });
    catalogue.add({
        .id = "reweighting/2d-general-g/unbiased-density",
        .statement =
            "Clipped Voronoi weights over g p integrate e^(x+y) without bias from 3 samples of a density p that "
            "is not uniform.",
        .source = "ours, estimators/reweighting/cell_weight_2d.h",
        .kind = Kind::mean,
        .trial = {density_unbiased,
                  {two_piece_g, two_piece_pdf, 7},
                  {{"uniform-g", "g of uniform samples: 4.7 % too bright", {g_of_3, two_piece_pdf, 7}},
                   {"without-p", "not divided by the density", {two_piece_g, one, 4}}}},
    });
}

}  // namespace plumb::suites
