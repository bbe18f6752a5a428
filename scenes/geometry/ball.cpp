#include "scenes/geometry/ball.h"

#include "scenes/geometry/shape.h"

namespace plumb {

Ball ball_around(const std::vector<description::Shape>& shapes) {
    Box box;
    for (const description::Shape& shape : shapes) box.add(bounds(shape.geometry));
    if (shapes.empty()) return {};
    return {(box.low + box.high) / 2, length(box.high - box.low) / 2};
}

}  // namespace plumb
