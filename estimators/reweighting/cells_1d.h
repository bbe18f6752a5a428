#pragma once

#include <span>
#include <vector>

namespace plumb {

/// Lengths of the Voronoi cells of samples in [0,1], in the order of the samples: |V_i| is the measure of the points
/// nearer to sample i than to any other. They sum to 1; samples at one place share its cell equally. O(N log N), any
/// order of samples. Throws Error naming the first sample that is NaN or outside [0,1], or when there is none.

/// Cells clipped to [0,1].
std::vector<double> voronoi_weights_1d(std::span<const double> samples);

/// Cells on the circle, 0 ≡ 1: for i.i.d. uniform samples E[|V|] = 1/N wherever the sample lies.
std::vector<double> torus_weights_1d(std::span<const double> samples);

}  // namespace plumb
