#pragma once

#include <vector>

#include "core/vec3.h"

namespace plumb {

namespace description {
struct Shape;
}

/// All points within a distance.
struct Ball {
    Vec3 centre;
    double radius = 1;
};

/// Around all shapes; around none, the unit ball.
Ball ball_around(const std::vector<description::Shape>& shapes);

}  // namespace plumb
