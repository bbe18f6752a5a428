#include "estimators/reweighting/reweighting_2d.h"

#include "core/error.h"
#include "estimators/points/random_shift.h"
#include "estimators/reweighting/tent.h"
#include "estimators/voronoi/voronoi_2d.h"

namespace plumb {

Estimate weighted_sum(const Function<2>& f, std::span<const Point<2>> samples, std::span<const double> weights) {
    Estimate estimate{.evaluations = samples.size()};
    for (std::size_t i = 0; i < samples.size(); ++i) estimate.value += weights[i] * f(samples[i]);
    return estimate;
}

Estimate voronoi_estimate(const Function<2>& f, std::span<const Point<2>> samples) {
    return weighted_sum(f, samples, voronoi_areas(samples));
}

Estimate torus_estimate(const Function<2>& f, std::span<const Point<2>> samples) {
    return weighted_sum(f, samples, voronoi_areas_periodic(samples));
}

Estimate torus_tent_estimate(const Function<2>& f, std::span<const Point<2>> samples) {
    return torus_estimate([&f](const Point<2>& u) { return f(tent(u)); }, samples);
}

Estimate shifted_torus_estimate(const Function<2>& f, std::vector<Point<2>> samples, RandomStream& random) {
    return torus_estimate(f, random_shift<2>(std::move(samples), random));
}

std::vector<double> reweighted_weights_2d(std::span<const Point<2>> samples, const Function<2>& g,
                                          const Function<2>& pdf) {
    std::vector<double> weights = voronoi_areas(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double divisor = g(samples[i]) * pdf(samples[i]);
        if (!(divisor > 0))
            throw Error(fmt::format("sample {} at ({}, {}): g p is {}; it must be positive", i, samples[i][0],
                                    samples[i][1], divisor));
        weights[i] /= divisor;
    }
    return weights;
}

}  // namespace plumb
