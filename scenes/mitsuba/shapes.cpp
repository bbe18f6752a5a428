#include <cmath>

#include <fmt/format.h>

#include "scenes/description/obj.h"
#include "scenes/description/ply.h"
#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using namespace description;

namespace {

Mesh load_mesh(const std::string& type, Properties& properties) {
    Mesh mesh = type == "obj" ? read_obj(properties.file("filename")) : read_ply(properties.file("filename"));
    const bool flip_uvs = properties.boolean("flip_tex_coords", type == "obj");
    if (flip_uvs != (type == "obj")) {
        for (auto& uv : mesh.uvs) uv[1] = 1 - uv[1];
    }
    if (properties.boolean("face_normals", false)) {
        mesh.normals.clear();
    } else if (mesh.normals.empty()) {
        add_smooth_normals(mesh);
    }
    properties.number("max_smooth_angle", 0);
    properties.boolean("collapse", false);
    return mesh;
}

Sphere load_sphere(Properties& properties, const Transform& to_world) {
    const Vec3 center = properties.vector("center", {0, 0, 0});
    const double radius = properties.number("radius", 1);
    const Place& place = properties.element().place;
    if (!(radius > 0))
        throw properties.place_of("radius").error(fmt::format("a sphere of radius {}; above 0 is accepted", radius));
    Sphere sphere{.center = to_world.point(center),
                  .radius = radius,
                  .flip_normals = properties.boolean("flip_normals", false),
                  .to_world = to_world * Transform::translate(center) * Transform::scale({radius, radius, radius})};
    const double x = length(to_world.vector({1, 0, 0})), y = length(to_world.vector({0, 1, 0})),
                 z = length(to_world.vector({0, 0, 1}));
    const Vec3 a = to_world.vector({1, 0, 0}) / x, b = to_world.vector({0, 1, 0}) / y,
               c = to_world.vector({0, 0, 1}) / z;
    const double skew = std::max({std::abs(dot(a, b)), std::abs(dot(b, c)), std::abs(dot(c, a))});
    // Matrices in files have six digits.
    if (std::abs(x - y) > 1e-4 * x || std::abs(x - z) > 1e-4 * x || skew > 1e-4) {
        throw place.error(fmt::format("a sphere scaled by {} {} {}; uniform scaling is accepted", x, y, z));
    }
    sphere.radius = radius * std::cbrt(std::abs(to_world.determinant()));
    return sphere;
}

Disk load_disk(Properties& properties, const Transform& to_world) {
    const double side = properties.boolean("flip_normals", false) ? -1 : 1;
    return {.center = to_world.point({}),
            .axis_x = to_world.vector({1, 0, 0}),
            .axis_y = to_world.vector({0, 1, 0}),
            .normal = normalize(to_world.normal({0, 0, side}))};
}

// Finite in its file, a vertex may still be no float after its transform.
void check_finite(const Mesh& mesh, const Place& place) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (const float x : mesh.positions[i]) {
            if (!std::isfinite(x))
                throw place.error(fmt::format("vertex {} has the coordinate {}; finite floats are accepted", i, x));
        }
    }
}

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
    Properties properties(element, loader);
    const std::string& type = element.attribute("type");
    const Transform to_world = properties.transform("to_world");
    Shape shape{.geometry = Mesh{},
                .material = {},
                .emitter = {},
                .id = element.has("id") ? element.attribute("id") : "",
                .place = element.place};
    bool has_material = false;
    for (const XmlElement& child : element.children) {
        if (child.tag != "bsdf" && child.tag != "ref" && child.tag != "emitter") continue;
        const XmlElement& target = loader.resolve(child);
        if (target.tag == "bsdf") {
            shape.material = load_material(target, loader);
            has_material = true;
        } else if (target.tag == "emitter") {
            shape.emitter = load_area_emitter(target, loader);
        }
    }
    if (!has_material) {
        shape.material = {static_cast<std::uint32_t>(loader.scene.materials.size())};
        loader.scene.materials.push_back({.kind = Diffuse{}, .id = "", .place = element.place});
    }
    if (type == "sphere") {
        shape.geometry = load_sphere(properties, to_world);
    } else if (type == "disk") {
        shape.geometry = load_disk(properties, to_world);
    } else {
        Mesh mesh;
        if (type == "obj" || type == "ply")
            mesh = load_mesh(type, properties);
        else if (type == "rectangle")
            mesh = rectangle_mesh();
        else if (type == "cube")
            mesh = cube_mesh();
        else
            throw loader.unknown_plugin(element);
        if (properties.boolean("flip_normals", false)) flip_normals(mesh);
        mesh = transformed(std::move(mesh), to_world);
        check_finite(mesh, element.place);
        shape.geometry = std::move(mesh);
    }
    properties.finish();
    check_area(shape);
    return shape;
}

}  // namespace plumb::mitsuba
