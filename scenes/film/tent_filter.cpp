#include "scenes/film/tent_filter.h"

namespace plumb {

TentFilter::TentFilter(double radius) : radius_(positive_size(radius, "tent filter: the radius")) {}

TentFilter TentFilter::load(description::Properties& properties) {
    return TentFilter(checked_radius(properties, properties.number("radius", 1)));
}

}  // namespace plumb
