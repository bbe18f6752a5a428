#pragma once

#include <vector>

#include "core/vec3.h"

namespace plumb {

namespace description {
struct Shape;
}

/// All points within a distance of a centre.
struct Ball {
    Vec3 centre;
    double radius = 1;
};

/// A ball around all shapes; the unit ball where there are none.
Ball ball_around(const std::vector<description::Shape>& shapes);

}  // namespace plumb
