// Weights by cells on the torus: without bias for any integrand.
#include <numbers>

#include "estimators/points/random_shift.h"
#include "estimators/points/stratified.h"
#include "estimators/reweighting/reweighting_2d.h"
#include "estimators/reweighting/tent.h"
#include "estimators/voronoi/voronoi_2d.h"
#include "verification/suites/reweighting/subjects_2d.h"

namespace plumb::suites {
namespace {

Verdict unbiased(const Draw& draw, double delta, const Run& run) {
    return mean_is(draw, {.reference = exp_sum_integral, .delta = delta, .bounds = exp_sum_bounds}, run);
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
Verdict mean_cell_is_one_in_n(const Weigh& weigh, const Run& run) {
    const auto cell = [=](RandomStream& random) {
        Samples x = independent_points<2>(4, random);
        x[0] = {0.1, 0.3};
        return weigh(x)[0];
    };
    return mean_is(cell, {.reference = 0.25, .delta = 0.01, .bounds = {0, 1}}, run);
}

using Shift = Samples (*)(Samples, RandomStream&);

Samples first_axis_shifted(Samples points, RandomStream& random) {
    const double shift = random.uniform();
    for (Point<2>& x : points) x[0] = std::fmod(x[0] + shift, 1.0);
    return points;
}

struct Shifted {
    Shift shift;
    Weigh weigh;
};

Verdict unbiased_after_shift(const Shifted& subject, const Run& run) {
    const auto draw = [&, shift = subject.shift, weigh = subject.weigh](RandomStream& random) {
        const Samples x = shift({{0.1, 0.1}, {0.15, 0.1}, {0.1, 0.3}, {0.6, 0.65}}, random);
        return weighted_sum(exp_sum, x, weigh(x)).value;
    };
    return mean_is(draw, {.reference = exp_sum_integral, .delta = 0.02, .bounds = exp_sum_bounds}, run);
}

}  // namespace

void add_reweighting_torus_2d(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-torus/unbiased",
        .statement =
            "Torus weights of 4 independent samples integrate e^(x+y) without bias, though it is not periodic.",
        .source =
            "ours, estimators/reweighting/reweighting_2d.h; [thesis, appendix A.2] calls the periodic scheme biased",
        .kind = Kind::mean,
        .trial = {[](const Draw& draw, const Run& run) { return unbiased(draw, 0.014, run); },
                  weighted(exp_sum, 4, voronoi_areas_periodic),
                  {{"clipped", "clipped cells called unbiased: bias -0.042", weighted(exp_sum, 4, voronoi_areas)},
                   {"copies-missing-on-the-left", "periodic copies are added on three sides only",
                    weighted(exp_sum, 4, copies_missing_on_the_left)}}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus/mean-cell",
        .statement = "The cell of a sample at a fixed place on the torus, among 3 uniform ones, has the mean area 1/4.",
        .source = "ours, estimators/reweighting/reweighting_2d.h",
        .kind = Kind::mean,
        .trial = {mean_cell_is_one_in_n,
                  voronoi_areas_periodic,
                  {{"clipped", "clipped cells: bias -0.032", voronoi_areas},
                   {"diagonal-copies-missing", "periodic copies only to the left, right, below and above",
                    diagonal_copies_missing}}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus-tent/unbiased",
        .statement = "Torus weights of 4 independent samples, the integrand folded by the tent map, integrate e^(x+y) "
                     "without bias.",
        .source = "ours, estimators/reweighting/reweighting_2d.h",
        .kind = Kind::mean,
        .trial = {[](const Draw& draw, const Run& run) { return unbiased(draw, 0.04, run); },
                  weighted(tented, 4, voronoi_areas_periodic),
                  {{"without-factor", "the tent without its factor 2 covers a quarter of the square: bias -1.27",
                    weighted(half_tented, 4, voronoi_areas_periodic)},
                   {"sine", "a smooth fold in place of the tent, without its Jacobian: bias +0.122",
                    weighted(sine_tented, 4, voronoi_areas_periodic)},
                   {"clipped", "clipped cells under the tent: bias +0.31", weighted(tented, 4, voronoi_areas)}}},
    });
    catalogue.add({
        .id = "reweighting/2d-shifted-torus/unbiased",
        .statement = "Any 4 points, moved by one uniform vector and weighted by their cells on the torus, integrate "
                     "e^(x+y) without bias.",
        .source = "ours, estimators/reweighting/reweighting_2d.h",
        .kind = Kind::mean,
        .trial = {unbiased_after_shift,
                  {random_shift<2>, voronoi_areas_periodic},
                  {{"no-shift",
                    "the points stay where they are",
                    {[](Samples x, RandomStream&) { return x; }, voronoi_areas_periodic}},
                   {"one-axis",
                    "the points are shifted along the first axis only",
                    {first_axis_shifted, voronoi_areas_periodic}},
                   {"clipped", "clipped cells after the shift: bias -0.058", {random_shift<2>, voronoi_areas}}}},
    });
}

}  // namespace plumb::suites
