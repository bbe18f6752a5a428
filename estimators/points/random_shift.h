#pragma once

#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// The points moved by one uniform vector on the torus, where 0 ≡ 1: each becomes uniform on [0,1)^D, their
/// differences stay. Source: [Cranley & Patterson 1976].
template <int D>
std::vector<Point<D>> random_shift(std::vector<Point<D>> points, RandomStream& random) {
    Point<D> shift;
    for (double& s : shift) s = random.uniform();
    for (Point<D>& point : points)
        for (int axis = 0; axis < D; ++axis) {
            const double moved = point[axis] + shift[axis];
            point[axis] = moved < 1 ? moved : moved - 1;
        }
    return points;
}

}  // namespace plumb
