#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using description::Shape;

namespace {

void check_area(const Shape& shape) {
    if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry); mesh && shape.emitter) {
        for (const auto& t : mesh->triangles) {
            const Vec3 p = mesh->position(t[0]);
            if (length_squared(cross(mesh->position(t[1]) - p, mesh->position(t[2]) - p)) > 0) return;
        }
        throw shape.emitter->place.error("an area emitter on a mesh of area 0; above 0 is accepted");
    }
}

}  // namespace

Shape load_shape(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    Shape shape{.geometry = Mesh{},
                .material = {},
                .emitter = {},
                .id = element.has("id") ? element.attribute("id") : "",
                .place = element.place};
    if (const XmlElement* emitter = properties.part("emitter")) shape.emitter = load_area_emitter(*emitter, loader);
    if (const XmlElement* material = properties.part("bsdf")) {
        shape.material = load_material(*material, loader);
    } else {
        shape.material = {static_cast<std::uint32_t>(loader.scene.materials.size())};
        loader.scene.materials.push_back({.kind = description::Diffuse{}, .id = "", .place = element.place});
    }
    auto geometry = load_model<description::Geometry>(description::ShapeModels{}, properties);
    if (!geometry) throw loader.unknown_plugin(element);
    shape.geometry = *std::move(geometry);
    properties.finish();
    check_area(shape);
    return shape;
}

}  // namespace plumb::mitsuba
