#pragma once

#include <functional>
#include <vector>

namespace plumb::checks {

/// A rectangle of the plane over which is integrated.
struct Rectangle {
    double x_low, x_high, y_low, y_high;
};

/// The integrals over rectangles, with an estimate of their error.
struct Cubature {
    std::vector<double> values;  ///< of the integral over each rectangle given
    double total = 0;
    double error = 0;  ///< of the total: the sum of differences between a rule of degree 7 and one of degree 5
};

/// The integrals of f(x, y) over every rectangle, refined where the rules of degree 7 and 5 [Genz & Malik 1983] differ
/// most, until the error is below the tolerance or `evaluations` are spent.
Cubature integrate(const std::function<double(double, double)>& f, const std::vector<Rectangle>& rectangles,
                   double tolerance, std::size_t evaluations);

}  // namespace plumb::checks
