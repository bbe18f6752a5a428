#include "scenes/film/cosine_filter.h"

namespace plumb {

CosineFilter::CosineFilter(double radius)
    : radius_(positive_size(radius, "cosine filter: the radius")), scale_(std::numbers::pi / (2 * radius)) {}

CosineFilter CosineFilter::load(description::Properties& properties) {
    return CosineFilter(checked_radius(properties, properties.number("radius", 1)));
}

}  // namespace plumb
