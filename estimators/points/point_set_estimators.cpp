#include "estimators/points/point_set_estimators.h"

#include "estimators/points/mean_over.h"

namespace plumb {
namespace {

template <int D>
std::vector<Estimator<D>> estimators_of(const std::vector<PointSet<D>>& sets) {
    std::vector<Estimator<D>> list;
    for (const PointSet<D>& set : sets) list.push_back(mean_estimator(set));
    return list;
}

}  // namespace

template <int D>
Estimator<D> mean_estimator(const PointSet<D>& set) {
    const auto mean = set.independent ? mean_over_independent<D> : mean_over<D>;
    return {.id = set.id,
            .summary = set.summary,
            .source = set.source,
            .unbiased = set.randomised,
            .run = [generate = set.generate, mean](const Function<D>& f, std::uint64_t n,
                                                   RandomStream& random) { return mean(generate(n, random), f); },
            .expected_slope = set.expected_slope,
            .randomised = set.randomised};
}
template Estimator<1> mean_estimator(const PointSet<1>&);
template Estimator<2> mean_estimator(const PointSet<2>&);

std::vector<Estimator<1>> point_set_estimators_1d() {
    return estimators_of(point_sets_1d());
}
std::vector<Estimator<2>> point_set_estimators_2d() {
    return estimators_of(point_sets_2d());
}

}  // namespace plumb
