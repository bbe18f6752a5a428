#include "scenes/sensors/scene_sensor.h"

namespace plumb {

namespace {

// Mitsuba's camera looks along +z with x to the left of the image.
CameraPose pose_of(const Transform& to_world) {
    const auto axis = [&](Vec3 local) { return normalize(to_world.vector(local)); };
    return {to_world.point({0, 0, 0}), axis({-1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
}

SceneSensor::Model widened(const auto& model) {
    return model;
}
template <class... Models>
SceneSensor::Model widened(const std::variant<Models...>& model) {
    return std::visit([](const auto& one) { return SceneSensor::Model(one); }, model);
}

SceneSensor::Model model_of(const description::Sensor& sensor, double margin) {
    const FilmSize size{sensor.film.width, sensor.film.height};
    const CameraPose pose = pose_of(sensor.to_world);
    try {
        return std::visit([&](const auto& kind) { return widened(kind.model(pose, size, margin)); }, sensor.kind);
    } catch (const Error& error) {
        throw sensor.place.error(error.what());
    }
}

}  // namespace

SceneSensor::SceneSensor(const description::Sensor& sensor)
    : film_{sensor.film.width, sensor.film.height},
      filter_(sensor.film.filter),
      model_(model_of(sensor, margin(filter_))) {}

}  // namespace plumb
