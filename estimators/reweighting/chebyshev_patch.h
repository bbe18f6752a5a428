#pragma once

#include <functional>
#include <vector>

#include "analytic/disk_rectangle.h"
#include "core/point.h"

namespace plumb {

/// A function on a rectangle by its values at count × count Chebyshev points (of the second kind, the boundary
/// included), interpolated by polynomials in barycentric form [Berrut & Trefethen 2004, eq. 5.4]. count ≥ 2.
class ChebyshevPatch {
public:
    ChebyshevPatch(const Rectangle& box, int count, const std::function<double(const Point<2>&)>& f);

    [[nodiscard]] const Rectangle& box() const { return box_; }
    [[nodiscard]] double operator()(const Point<2>& x) const;
    [[nodiscard]] const std::vector<double>& values() const { return values_; }

private:
    Rectangle box_;
    std::vector<double> nodes_;   ///< on (0,1), for both axes
    std::vector<double> values_;  ///< row by row, the second axis fastest
};

}  // namespace plumb
