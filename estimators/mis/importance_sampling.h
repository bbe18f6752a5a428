#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/estimate.h"
#include "core/moments.h"
#include "estimators/densities/technique.h"
#include "estimators/estimator.h"

namespace plumb {

/// The mean of f(X)/p(X) over n samples of density p; unbiased when p > 0 wherever f ≠ 0.
/// Throws Error when the technique returns a point where its own density is not positive and finite.
template <int D>
Estimate importance_sampling(const Function<D>& f, const Technique<D>& technique, std::uint64_t n,
                             RandomStream& random) {
    Moments values;
    for (std::uint64_t j = 0; j < n; ++j) {
        const Point<D> x = technique.sample(uniform_point<D>(random));
        const double pdf = technique.pdf(x);
        if (!(pdf > 0 && std::isfinite(pdf)))
            throw Error(fmt::format("technique '{}': sample {} has the density {}", technique.name, j, pdf));
        values.add(f(x) / pdf);
    }
    return {values.mean(), values.standard_error(), n};
}

}  // namespace plumb
