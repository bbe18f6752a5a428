#pragma once

#include <string>
#include <vector>

#include "core/interval.h"
#include "verification/pictures/picture.h"

namespace plumb {

/// An error of a against b, from which the part of b's own variance is subtracted, with a 95 % interval over pixels; of
/// NaN where the error of a picture is unknown, or its part in this number.
struct ErrorMeasure {
    std::string name;
    double value = 0;
    Interval interval{};
};

/// The errors over all channels and all pixels that are finite in both, with d = a − b, m = b's mean: RMSE = √⟨d²⟩;
/// relMSE = ⟨d²⟩ / ⟨b²⟩; MAPE = ⟨|d| / (|b| + m/100)⟩; MRSE = ⟨d² / (b² + (m/100)²)⟩. Each d² loses b's variance, and
/// so does b² of relMSE; each |d| is multiplied by √(va/(va + vb)), as is right for normal errors without bias.
/// `inflation` is the factor of the variance of sums over pixels that correlated neighbours cause; NaN where errors are
/// unknown.
std::vector<ErrorMeasure> errors_of(const Picture& a, const Picture& b, double inflation);

}  // namespace plumb
