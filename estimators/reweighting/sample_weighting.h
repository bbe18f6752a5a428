#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/point.h"

namespace plumb {

/// A way to weight samples that somebody else drew, for the estimate Σ w_i f(x_i) of ∫ f over [0,1]^D. Ids are those of
/// the estimators that draw such samples themselves.
template <int D>
struct SampleWeighting {
    std::string id;
    std::string known;  ///< what is known about the estimate, and for which samples
    /// The weights in the order of the samples; throws Error for samples outside the cube and for none.
    std::function<std::vector<double>(std::span<const Point<D>>)> weights;
};

template <int D>
const std::vector<SampleWeighting<D>>& sample_weightings();
/// The weighting of this name; throws Error naming the nearest one.
template <int D>
const SampleWeighting<D>& find_sample_weighting(std::string_view id);

/// The number of samples that lie where an earlier one lies; on the torus 0 and 1 are one place.
template <int D>
std::size_t repeated_places(std::vector<Point<D>> samples, bool torus);

}  // namespace plumb
