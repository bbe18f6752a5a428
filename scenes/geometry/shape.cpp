#include "scenes/geometry/shape.h"

namespace plumb::description {

namespace {

Box bounds_of(const auto& shape) {
    return shape.bounds();
}
Box bounds_of(const Mesh& mesh) {
    Box box;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) box.add(mesh.position(i));
    return box;
}

}  // namespace

Box bounds(const Geometry& geometry) {
    return std::visit([](const auto& shape) { return bounds_of(shape); }, geometry);
}

}  // namespace plumb::description
