#pragma once

#include <cmath>

#include "core/point.h"

namespace plumb {

/// An axis-parallel box, low < high on every axis; by default the unit cube.
template <int D>
struct Box {
    Point<D> low = filled(0), high = filled(1);

    [[nodiscard]] double volume() const {
        double product = 1;
        for (int axis = 0; axis < D; ++axis) product *= high[axis] - low[axis];
        return product;
    }
    [[nodiscard]] bool contains(double x, int axis) const { return low[axis] <= x && x <= high[axis]; }
    /// Coordinate x of the box as one of the unit cube; rounding is monotone, so the result lies in [0,1].
    [[nodiscard]] double to_unit(double x, int axis) const { return (x - low[axis]) / (high[axis] - low[axis]); }
    [[nodiscard]] Point<D> from_unit(Point<D> u) const {
        for (int axis = 0; axis < D; ++axis) u[axis] = std::lerp(low[axis], high[axis], u[axis]);
        return u;
    }

private:
    static constexpr Point<D> filled(double value) {
        Point<D> point{};
        point.fill(value);
        return point;
    }
};

}  // namespace plumb
