// These claims say how fast the errors of torus weights fall.
#include <numbers>

#include "estimators/points/stratified.h"
#include "estimators/reweighting/reweighting_2d.h"
#include "estimators/reweighting/tent.h"
#include "estimators/voronoi/voronoi_2d.h"
#include "verification/evidence/rate.h"
#include "verification/suites/reweighting/subjects_2d.h"

namespace plumb::suites {
namespace {

double tented(const Point<2>& u) {
    return exp_sum(tent(u));
}

struct RateSubject {
    std::string estimator, integrand;
    Function<2> f;
    double truth;
};

struct Weighted {
    RateSubject of;
    Weigh weigh;
};

Verdict falls_as(const RateSubject& subject, const Weigh& weigh, std::vector<std::uint64_t> n, std::uint64_t replicates,
                 double exponent, const Run& run) {
    const Replicate replicate = [=](std::uint64_t count, RandomStream& random) {
        const Samples x = independent_points<2>(count, random);
        return weighted_sum(subject.f, x, weigh(x));
    };
    return rate_is(replicate, {subject.estimator, subject.integrand, subject.truth, n, replicates},
                   {exponent - 0.2, exponent + 0.2}, run);
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

}  // namespace

void add_reweighting_rates_2d(Catalogue& catalogue) {
    const std::vector<std::uint64_t> small{16, 32, 64, 128, 256}, middle{64, 128, 256, 512},
        large{256, 512, 1024, 2048};
    const RateSubject torus{"torus", "e^(x+y)", exp_sum, exp_sum_integral};
    catalogue.add({
        .id = "reweighting/2d-torus/rate",
        .statement = "The MSE of torus weights falls as N^-1.5 where the periodic extension jumps.",
        .source = "ours: -1 - (1 + 2k)/D, estimators/reweighting/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .trial = {[=](const Weigh& weigh, const Run& run) { return falls_as(torus, weigh, small, 1500, -1.5, run); },
                  voronoi_areas_periodic,
                  {{"equal-weights", "weights 1/N: -1", equal_weights},
                   {"clipped", "clipped cells: -2 and steeper", voronoi_areas}}},
    });
    const RateSubject tent_plane{"torus-tent", "x+2y", [](const Point<2>& u) { return plane(tent(u)); }, 1.5};
    const RateSubject one_axis{"torus-tent", "x+2y", [](const Point<2>& u) { return plane({tent(u[0]), u[1]}); }, 1.5};
    catalogue.add({
        .id = "reweighting/2d-torus-tent/rate",
        .statement = "The MSE of torus weights under the tent map falls as N^-2.5: the tent leaves a kink.",
        .source = "ours: -1 - (1 + 2k)/D, estimators/reweighting/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .trial = {[=](const RateSubject& subject, const Run& run) {
                      return falls_as(subject, voronoi_areas_periodic, middle, 2000, -2.5, run);
                  },
                  tent_plane,
                  {{"one-axis", "the tent on one axis leaves the jump of the other: -1.5", one_axis}}},
    });
    const RateSubject tent_exp{"torus-tent", "e^(x+y)", tented, exp_sum_integral};
    catalogue.add({
        .id = "reweighting/2d-torus-tent/rate-exp",
        .statement = "The MSE of torus weights under the tent map falls as N^-2.5 for e^(x+y).",
        .source = "ours: -1 - (1 + 2k)/D, estimators/reweighting/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .trial = {[=](const RateSubject& subject, const Run& run) {
                      return falls_as(subject, voronoi_areas_periodic, large, 2000, -2.5, run);
                  },
                  tent_exp,
                  {{"no-tent", "without the tent: -1.5", torus}}},
        .sizes = Sizes::full_only,
    });
    const RateSubject smooth{"torus", "1+(cos 2πx + sin 2πy)/2", wave, 1};
    catalogue.add({
        .id = "reweighting/2d-torus/rate-smooth",
        .statement = "The MSE of torus weights falls as N^-3 for an integrand that is smooth on the torus.",
        .source = "ours: -1 - 4/D, estimators/reweighting/reweighting_estimators_2d.cpp",
        .kind = Kind::rate,
        .trial = {[=](const Weighted& subject, const Run& run) {
                      return falls_as(subject.of, subject.weigh, large, 2000, -3, run);
                  },
                  {smooth, voronoi_areas_periodic},
                  {{"equal-weights", "weights 1/N: -1", {smooth, equal_weights}},
                   {"jump", "an integrand that jumps on the torus: -1.5", {torus, voronoi_areas_periodic}}}},
        .sizes = Sizes::full_only,
    });
}

}  // namespace plumb::suites
