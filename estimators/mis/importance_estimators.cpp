#include "estimators/mis/importance_estimators.h"

#include <cmath>

#include "estimators/debiasing/russian_roulette.h"
#include "estimators/densities/density.h"
#include "estimators/densities/density_2d.h"
#include "estimators/mis/control_variate.h"
#include "estimators/mis/importance_sampling.h"
#include "estimators/mis/mis_estimators.h"
#include "estimators/replicates/independent_slope.h"

namespace plumb {
namespace {

template <int D>
std::vector<Technique<D>> shipped_techniques();

template <>
std::vector<Technique<1>> shipped_techniques<1>() {
    return {technique_1d("uniform", UniformDensity{}), technique_1d("linear", LinearDensity(1, 3)),
            technique_1d("peaked", TruncatedExponential(6))};
}

template <>
std::vector<Technique<2>> shipped_techniques<2>() {
    using Peak = ProductDensity<TruncatedExponential, TruncatedExponential>;
    return {technique_2d("uniform", ProductDensity<UniformDensity, UniformDensity>{}),
            technique_2d("bilinear", BilinearDensity(1, 2, 2, 3)),
            technique_2d("peaked", Peak{TruncatedExponential(4), TruncatedExponential(4)})};
}

std::vector<std::uint64_t> equal_counts(std::uint64_t n, std::size_t techniques) {
    std::vector<std::uint64_t> counts(techniques, n / techniques);
    for (std::size_t i = 0; i < n % techniques; ++i) ++counts[i];
    return counts;
}

template <int D, class Heuristic>
Estimator<D> multi_sample(std::string id, std::string summary, std::string source, Heuristic heuristic) {
    return {.id = std::move(id),
            .summary = std::move(summary),
            .source = std::move(source),
            .run =
                [heuristic, techniques = shipped_techniques<D>()](const Function<D>& f, std::uint64_t n,
                                                                  RandomStream& random) {
                    return mis_multi_sample<D>(f, techniques, equal_counts(n, techniques.size()), heuristic, random);
                },
            .expected_slope = independent_slope<D>};
}

template <int D>
std::vector<Estimator<D>> importance_estimators() {
    const auto techniques = shipped_techniques<D>();
    const ControlVariate<D> coordinates{[](const Point<D>& x) {
                                            double sum = 0;
                                            for (const double coordinate : x) sum += coordinate;
                                            return sum;
                                        },
                                        D / 2.0};
    return {
        {.id = "importance-linear",
         .summary = "Importance sampling with a density that rises linearly along each axis.",
         .source = "[Kahn & Marshall 1953]",
         .run = [linear = techniques[1]](const Function<D>& f, std::uint64_t n,
                                         RandomStream& random) { return importance_sampling<D>(f, linear, n, random); },
         .expected_slope = independent_slope<D>},
        multi_sample<D>("mis-balance", "Uniform, linear and peaked sampling in equal shares, balance heuristic.",
                        "[Veach & Guibas 1995]", Balance{}),
        multi_sample<D>("mis-power", "Uniform, linear and peaked sampling in equal shares, power heuristic, beta = 2.",
                        "[Veach & Guibas 1995]", Power{}),
        {.id = "mis-one-sample",
         .summary = "Uniform, linear or peaked sampling at random, balance heuristic.",
         .source = "[Veach 1997, section 9.2.4]",
         .run =
             [techniques](const Function<D>& f, std::uint64_t n, RandomStream& random) {
                 const std::vector<double> probabilities(techniques.size(), 1);
                 return mis_one_sample<D>(f, techniques, probabilities, Balance{}, n, random);
             },
         .expected_slope = independent_slope<D>},
        {.id = "control-variate-fitted",
         .summary = "Sum of the coordinates as control variate, coefficient fitted with cross-fitting in 4 folds.",
         .source = "ours, estimators/mis/control_variate.h",
         .run = [coordinates](const Function<D>& f, std::uint64_t n,
                              RandomStream& random) { return control_variate_fitted<D>(f, coordinates, n, random); },
         .expected_slope = independent_slope<D>},
        {.id = "roulette",
         .summary = "Uniform samples, each evaluated with probability 1/2 and then counted twice.",
         .source = "[Arvo & Kirk 1990]",
         .run = [](const Function<D>& f, std::uint64_t n,
                   RandomStream& random) { return roulette<D>(f, 0.5, n, random); },
         .expected_slope = independent_slope<D>},
    };
}

}  // namespace

std::vector<Estimator<1>> importance_estimators_1d() {
    return importance_estimators<1>();
}
std::vector<Estimator<2>> importance_estimators_2d() {
    return importance_estimators<2>();
}

}  // namespace plumb
