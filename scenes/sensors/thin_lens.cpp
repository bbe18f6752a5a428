#include "scenes/sensors/thin_lens.h"

#include <fmt/format.h>

#include "core/error.h"
#include "estimators/densities/warps.h"

namespace plumb {

ThinLens::ThinLens(const CameraPose& pose, FilmSize size, double fov, double radius, double focus, FovAxis axis,
                   double margin)
    : pose_(pose), plane_(size, fov, axis, margin), radius_(radius), focus_(focus) {
    const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    if (!positive(radius) || !positive(focus))
        throw Error(
            fmt::format("thin lens of radius {} in focus at {}: both must be positive and finite; without a "
                        "radius it is a pinhole",
                        radius, focus));
}

Vec3 ThinLens::lens_point(const Point<2>& lens) const {
    const Point<2> p = sample_concentric_disk(lens);
    return {radius_ * p[0], radius_ * p[1], 0};
}

Ray ThinLens::sample_ray(const Point<2>& film, const Point<2>& lens) const {
    const Vec3 origin = lens_point(lens), in_focus = plane_.place(film) * focus_;
    const Frame axes = pose_.axes();
    return {pose_.position + axes.to_world(origin), normalize(axes.to_world(in_focus - origin))};
}

double ThinLens::pdf(const Ray& ray) const {
    const Frame axes = pose_.axes();
    const Vec3 origin = axes.to_local(ray.origin - pose_.position), direction = axes.to_local(ray.direction);
    if (!(direction.z > 0)) return 0;
    return plane_.film_at(origin + direction * (focus_ / direction.z)) ? plane_.pixels_per_steradian(direction.z) : 0;
}

std::optional<SensorSample> ThinLens::connect(Vec3 from, const Point<2>& lens) const {
    const Frame axes = pose_.axes();
    const Vec3 origin = lens_point(lens), way = axes.to_local(from - pose_.position) - origin;
    if (!(way.z > 0)) return {};
    const auto film = plane_.film_at(origin + way * (focus_ / way.z));
    if (!film) return {};
    const double distance = length(way), cos = way.z / distance, area = pi * radius_ * radius_;
    return SensorSample{*film,
                        -axes.to_world(way / distance),
                        distance,
                        plane_.pixels_per_steradian(cos) / (area * cos),
                        distance * distance / (cos * area),
                        Measure::solid_angle};
}

namespace description {

ThinLens ThinLens::load(Properties& properties, const Film& film) {
    const double far_clip = properties.number("far_clip", 1e4);  // where Mitsuba focuses unless told otherwise
    ThinLens lens{.fov_x = load_fov_x(properties, film),
                  .aperture_radius = properties.number("aperture_radius", 0),
                  .focus_distance = properties.number("focus_distance", far_clip)};
    if (!(lens.aperture_radius >= 0))
        throw properties.place_of("aperture_radius")
            .error(fmt::format("aperture_radius is {}; values from 0 are accepted", lens.aperture_radius));
    if (!(lens.focus_distance > 0))
        throw properties.place_of("focus_distance")
            .error(fmt::format("focus_distance is {}; values above 0 are accepted", lens.focus_distance));
    return lens;
}

std::variant<plumb::ThinLens, plumb::Perspective> ThinLens::model(const CameraPose& pose, FilmSize size,
                                                                  double margin) const {
    if (aperture_radius > 0)
        return plumb::ThinLens(pose, size, fov_x, aperture_radius, focus_distance, FovAxis::x, margin);
    return plumb::Perspective(pose, size, fov_x, FovAxis::x, margin);
}

}  // namespace description

}  // namespace plumb
