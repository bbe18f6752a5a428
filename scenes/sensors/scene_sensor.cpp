#include "scenes/sensors/scene_sensor.h"

#include <fmt/format.h>

namespace plumb {

namespace {

// Mitsuba's camera looks along +z with x to the left of the image.
CameraPose pose_of(const Transform& to_world) {
    const auto axis = [&](Vec3 local) { return normalize(to_world.vector(local)); };
    return {to_world.point({0, 0, 0}), axis({-1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
}

std::variant<Perspective, ThinLens> model_of(const description::Sensor& sensor, double margin) {
    const FilmSize size{sensor.film.width, sensor.film.height};
    const CameraPose pose = pose_of(sensor.to_world);
    try {
        if (sensor.aperture_radius > 0)
            return ThinLens(pose, size, sensor.fov_x, sensor.aperture_radius, sensor.focus_distance, FovAxis::x,
                            margin);
        return Perspective(pose, size, sensor.fov_x, FovAxis::x, margin);
    } catch (const Error& error) {
        throw sensor.place.error(error.what());
    }
}

Filter filter_of(const description::Sensor& sensor) {
    const description::Filter& filter = sensor.film.filter;
    switch (filter.kind) {
        case description::FilterKind::box:
            if (filter.radius != 0.5)
                throw sensor.place.error(fmt::format("a box filter of radius {}; accepted is 0.5", filter.radius));
            return BoxFilter();
        case description::FilterKind::tent: return TentFilter(filter.radius);
        case description::FilterKind::gaussian: return GaussianFilter(filter.stddev);
    }
    throw Error("a filter of no kind");
}

}  // namespace

SceneSensor::SceneSensor(const description::Sensor& sensor)
    : film_{sensor.film.width, sensor.film.height},
      filter_(filter_of(sensor)),
      model_(model_of(sensor, margin(filter_))) {}

}  // namespace plumb
