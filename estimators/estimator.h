#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analytic/integrand.h"
#include "core/estimate.h"
#include "core/interval.h"
#include "core/point.h"
#include "core/random.h"

namespace plumb {

template <int D>
using Function = std::function<double(const Point<D>&)>;

/// An estimator of ∫ f over [0,1]^D under a name, for the command line and the claims. The code of each stands in a
/// file of its own as a free function that needs no registry; this is its line in the list.
template <int D>
struct Estimator {
    std::string id;       ///< e.g. "torus", "torus-tent", "sobol-owen"
    std::string summary;  ///< one sentence
    std::string source;
    bool unbiased = true;
    /// One independent run with n samples (or the nearest count the method can use: Estimate::evaluations tells).
    std::function<Estimate(const Function<D>&, std::uint64_t n, RandomStream&)> run;
    /// The exponent of the MSE that theory gives for an integrand of this smoothness, as an interval; empty: none
    /// known.
    std::function<std::optional<Interval>(const Integrand<D>&)> expected_slope;
    bool randomised = true;  ///< false: every run is the same, so runs tell nothing about the error
};

const std::vector<Estimator<1>>& estimators_1d();
const std::vector<Estimator<2>>& estimators_2d();

template <int D>
const std::vector<Estimator<D>>& estimators();
template <int D>
const Estimator<D>& find_estimator(std::string_view id);

}  // namespace plumb
