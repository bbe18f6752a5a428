#include "estimators/reweighting/sample_weighting.h"

#include <algorithm>

#include "core/error.h"
#include "core/named.h"
#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/reweighting_2d.h"
#include "estimators/reweighting/reweighting_estimators_2d.h"
#include "estimators/voronoi/voronoi_2d.h"

namespace plumb {
namespace {

template <int D>
SampleWeighting<D> plain_mean() {
    return {"independent", "unbiased for independent uniform samples", [](std::span<const Point<D>> samples) {
                return std::vector<double>(samples.size(), 1 / static_cast<double>(samples.size()));
            }};
}

auto on_numbers(std::vector<double> (*weigh)(std::span<const double>)) {
    return [weigh](std::span<const Point<1>> samples) {
        std::vector<double> numbers;
        numbers.reserve(samples.size());
        for (const Point<1>& sample : samples) numbers.push_back(sample[0]);
        return weigh(numbers);
    };
}

std::vector<double> reweighted(std::span<const Point<2>> samples) {
    return reweighted_weights_2d(samples, uniform_cell_weight(samples.size()), [](const Point<2>&) { return 1.0; });
}

const char* const cells =
    "consistent for any samples that fill the domain; biased at every n, and the error leaves that out";
const char* const torus =
    "unbiased for independent uniform samples and for any set moved by one uniform random shift on the torus; best for "
    "a periodic integrand";

}  // namespace

template <>
const std::vector<SampleWeighting<1>>& sample_weightings<1>() {
    static const std::vector<SampleWeighting<1>> all = {
        {"voronoi", cells, on_numbers(voronoi_weights_1d)},
        {"torus", torus, on_numbers(torus_weights_1d)},
        {"reweighted", "unbiased for independent uniform samples", on_numbers(reweighted_weights_1d)},
        {"stratified-reweighted", "unbiased for one uniform sample in each of n equal strata",
         on_numbers(stratified_reweighted_weights_1d)},
        plain_mean<1>(),
    };
    return all;
}

template <>
const std::vector<SampleWeighting<2>>& sample_weightings<2>() {
    static const std::vector<SampleWeighting<2>> all = {
        {"voronoi", cells, voronoi_areas},
        {"torus", torus, voronoi_areas_periodic},
        {"voronoi-reweighted", "unbiased for independent uniform samples", reweighted},
        plain_mean<2>(),
    };
    return all;
}

template <int D>
const SampleWeighting<D>& find_sample_weighting(std::string_view id) {
    return find_named(sample_weightings<D>(), id, D == 1 ? "method for 1D samples" : "method for 2D samples");
}
template const SampleWeighting<1>& find_sample_weighting<1>(std::string_view);
template const SampleWeighting<2>& find_sample_weighting<2>(std::string_view);

template <int D>
std::size_t repeated_places(std::vector<Point<D>> samples, bool torus) {
    for (Point<D>& sample : samples)
        for (double& x : sample) x = torus && x == 1 ? 0 : x;
    std::ranges::sort(samples);
    return static_cast<std::size_t>(samples.end() - std::unique(samples.begin(), samples.end()));
}
template std::size_t repeated_places<1>(std::vector<Point<1>>, bool);
template std::size_t repeated_places<2>(std::vector<Point<2>>, bool);

}  // namespace plumb
