#include "scenes/sensors/perspective.h"

namespace plumb {

Ray Perspective::sample_ray(const Point<2>& film, const Point<2>&) const {
    return {pose_.position, normalize(pose_.axes().to_world(plane_.place(film)))};
}

double Perspective::pdf(const Ray& ray) const {
    const Vec3 local = pose_.axes().to_local(ray.direction);
    return plane_.film_at(local) ? plane_.pixels_per_steradian(local.z) : 0;
}

std::optional<SensorSample> Perspective::connect(Vec3 from, const Point<2>&) const {
    const Vec3 way = from - pose_.position, local = pose_.axes().to_local(way);
    const auto film = plane_.film_at(local);
    if (!film) return {};
    const double distance = length(way);
    const double importance = plane_.pixels_per_steradian(local.z / distance) / (distance * distance);
    return SensorSample{*film, -way / distance, distance, importance, 1, Measure::discrete};
}

}  // namespace plumb
