#include "verification/suites/direct/direct_subjects.h"

#include "estimators/points/point_set_samples.h"
#include "estimators/points/zero_two.h"

namespace plumb::suites {

AtFilmPoint::AtFilmPoint(const Scene& scene, const Point<2>& film, PrimarySamples& rest) : rest_(rest) {
    const Point<2> corner{std::floor(film[0]), std::floor(film[1])};
    pixel_ = {static_cast<int>(corner[0]), static_cast<int>(corner[1]), 1, 1};
    for (std::size_t i = 0; i < 2; ++i)
        film_.u[i] =
            std::visit([&](const auto& f) { return f.invert(film[i] - corner[i] - 0.5); }, scene.sensor().filter());
}

Spectrum Measurement::draw(RandomStream& random) const {
    PointSetSamples numbers(owen_zero_two, n);
    const std::uint64_t seed = random.bits();
    PathRecord record;
    Spectrum sum;
    for (std::uint32_t i = 0; i < n; ++i) {
        numbers.start({seed, 0, i});
        if (film) {
            AtFilmPoint at_point(scene, *film, numbers);
            estimator.trace(scene, at_point.pixel(), at_point, record);
        } else {
            estimator.trace(scene, region, numbers, record);
        }
        for (const Splat& splat : record.splats)
            if (splat.edges <= edges) sum += splat.value;
    }
    return sum / n;
}

void DirectBy::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    trace_two_edges(scene, region, samples, record, reflected);
}

void Scaled::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    estimator->trace(scene, region, samples, record);
    for (Splat& splat : record.splats) splat.value *= factor;
}

description::MaterialId add_material(description::Scene& scene, decltype(description::Material::kind) kind) {
    scene.materials.push_back({std::move(kind), {}, {}});
    return {static_cast<std::uint32_t>(scene.materials.size() - 1)};
}

void add_shape(description::Scene& scene, decltype(description::Shape::geometry) geometry,
               description::MaterialId material, std::optional<Spectrum> radiance) {
    description::Shape shape{std::move(geometry), material, {}, {}, {}};
    if (radiance) shape.emitter = description::AreaEmitter{*radiance, {}};
    scene.shapes.push_back(std::move(shape));
}

void add_polygon(description::Scene& scene, const std::vector<Vec3>& corners, description::MaterialId material,
                 std::optional<Spectrum> radiance) {
    Mesh mesh;
    for (const Vec3& c : corners)
        mesh.positions.push_back({static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)});
    for (std::uint32_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({0, i - 1, i});
    if (corners.size() == 4) mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    add_shape(scene, std::move(mesh), material, radiance);
}

Vec3 perpendicular_to(Vec3 n) {
    return normalize(cross(n, std::abs(n.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
}

void add_receiver(description::Scene& scene, Vec3 point, Vec3 normal, description::MaterialId material, double half) {
    const Vec3 x = half * perpendicular_to(normal), y = cross(normal, x), centre = point + 0.3 * x - 0.2 * y;
    add_polygon(scene, {centre - 1.3 * x - y, centre + 1.3 * x - y, centre + 1.3 * x + y, centre - 1.3 * x + y},
                material);
}

description::Sensor camera(Vec3 from, Vec3 at, double fov_x, int width, int height) {
    description::Sensor sensor;
    sensor.to_world = Transform::look_at(from, at, perpendicular_to(normalize(at - from)));
    sensor.kind = description::Perspective{fov_x};
    sensor.film = {width, height, BoxFilter()};
    return sensor;
}

}  // namespace plumb::suites
