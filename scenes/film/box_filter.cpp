#include "scenes/film/box_filter.h"

namespace plumb {

BoxFilter BoxFilter::load(description::Properties& properties) {
    const double radius = checked_radius(properties, properties.number("radius", 0.5));
    if (radius != 0.5)
        throw properties.place().error(fmt::format("a box filter of radius {}; accepted is 0.5", radius));
    return {};
}

}  // namespace plumb
