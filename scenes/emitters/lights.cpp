#include "scenes/emitters/lights.h"

#include "scenes/bsdfs/texture.h"

namespace plumb {

namespace {

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        auto [a, b, c] = mesh.corners(i);
        if (mesh.turned_by_normals(i)) std::swap(b, c);
        triangles.push_back({a, b, c});
    }
    return triangles;
}

/// Two triangles that are halves of one parallelogram have the edge from a to c in common, up to their starting corner.
std::optional<RectangleLight> as_rectangle(const std::vector<Triangle>& triangles, const Spectrum& radiance) {
    if (triangles.size() != 2) return {};
    std::array<Vec3, 3> one{triangles[0].a, triangles[0].b, triangles[0].c};
    std::array<Vec3, 3> two{triangles[1].a, triangles[1].b, triangles[1].c};
    for (int i = 0; i < 3; ++i, std::ranges::rotate(one, one.begin() + 1))
        for (int j = 0; j < 3; ++j, std::ranges::rotate(two, two.begin() + 1))
            if (one[0] == two[0] && one[2] == two[1] && one[0] + one[2] == one[1] + two[2])
                return RectangleLight(one[0], one[1] - one[0], two[2] - one[0], radiance);
    return {};
}

Light light_of(const Mesh& mesh, const Spectrum& radiance) {
    std::vector<Triangle> triangles = triangles_of(mesh);
    if (const auto rectangle = as_rectangle(triangles, radiance)) return *rectangle;
    return MeshLight(std::move(triangles), radiance);
}

Light light_of(const description::Sphere& sphere, const Spectrum& radiance) {
    const auto side = sphere.flip_normals ? SphereLight::Side::inwards : SphereLight::Side::outwards;
    return SphereLight(sphere.center, sphere.radius, radiance, side);
}

Light light_of(const description::Disk& disk, const Spectrum& radiance) {
    const double a = length(disk.axis_x), b = length(disk.axis_y);
    if (std::abs(a - b) > 1e-9 * a || std::abs(dot(disk.axis_x, disk.axis_y)) > 1e-9 * a * b)
        throw Error(fmt::format("an emitting disk with axes of {} and {}: accepted are circles", a, b));
    return DiskLight(disk.center, disk.normal, a, radiance);
}

EnvironmentMap environment_of(const description::EnvironmentMap& map) {
    const Texels texels = read_texels(map.file);
    std::vector<Spectrum> pixels;
    pixels.reserve(texels.rgb.size() / 3);
    for (int y = 0; y < texels.height; ++y)
        for (int x = 0; x < texels.width; ++x) pixels.push_back(texels.texel(x, y) * map.scale);
    const auto axis = [&](Vec3 local) { return map.to_world.vector(local); };
    const Frame frame{axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
    for (const auto& [a, b, product] : {std::tuple{frame.x, frame.x, 1.},
                                        {frame.y, frame.y, 1.},
                                        {frame.z, frame.z, 1.},
                                        {frame.x, frame.y, 0.},
                                        {frame.y, frame.z, 0.},
                                        {frame.z, frame.x, 0.}})
        if (std::abs(dot(a, b) - product) > 1e-5) throw Error("to_world of an envmap: accepted are rotations");
    return {static_cast<std::size_t>(texels.width), static_cast<std::size_t>(texels.height), std::move(pixels), frame};
}

Light light_of(const description::EnvironmentMap& map) {
    return environment_of(map);
}
Light light_of(const description::ConstantSky& sky) {
    return ConstantEnvironment{sky.radiance};
}
Light light_of(const description::PointLight& light) {
    return PointLight{light.position, light.intensity};
}

template <class Make>
Light at_place(const description::Place& place, const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        throw place.error(error.what());
    }
}

}  // namespace

Light area_light(const description::Shape& shape) {
    return at_place(shape.emitter->place, [&] {
        return std::visit([&](const auto& geometry) { return light_of(geometry, shape.emitter->radiance); },
                          shape.geometry);
    });
}

Light shapeless_light(const description::Emitter& emitter) {
    return at_place(emitter.place,
                    [&] { return std::visit([](const auto& kind) { return light_of(kind); }, emitter.kind); });
}

bool is_environment(const Light& light) {
    return std::holds_alternative<ConstantEnvironment>(light) || std::holds_alternative<EnvironmentMap>(light);
}

double pdf_of_sample(const Light& light, Vec3 from, Vec3 direction, Vec3 position, Vec3 normal) {
    if (is_environment(light)) return std::visit([&](const auto& sky) { return sky.hit(from, direction)->pdf; }, light);
    if (std::holds_alternative<PointLight>(light)) return 1;
    const double cos_at_light = -dot(normal, direction);
    if (!(cos_at_light > 0)) return 0;
    const auto pdf = [&](const auto& emitter) {
        if constexpr (requires { emitter.pdf_area(); })
            return per_steradian(emitter.pdf_area(), length(position - from), cos_at_light);
        else if constexpr (requires { emitter.pdf(from); })
            return emitter.pdf(from);
        else
            return 0.0;
    };
    return std::visit(pdf, light);
}

}  // namespace plumb
