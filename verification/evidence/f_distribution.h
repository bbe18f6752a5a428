#pragma once

namespace plumb {

/// P(X > x) for the ratio of two chi-squares, each over its degrees of freedom, m and n; n may be infinite. By
/// Boost.Math.
double f_tail(double x, double m, double n);

}  // namespace plumb
