#pragma once

#include <utility>

#include "scenes/sensors/perspective.h"
#include "scenes/sensors/thin_lens.h"

namespace plumb {

namespace description {

/// All sensors, each with `model(pose, film size, margin)`, the sensor that it becomes.
using SensorModels = Types<Perspective, ThinLens>;

/// A sensor as the file has it. It looks along +z of its space, x to the image's left and y up, as Mitsuba's do.
struct Sensor {
    Transform to_world;
    OneOf<SensorModels> kind;
    Film film;
    Place place;
};

template <class Model>
Types<Model> models_in(const Model&);
template <class... Models>
Types<Models...> models_in(const std::variant<Models...>&);
template <class... Models>
Joined<decltype(models_in(std::declval<const Models&>().model(CameraPose(), FilmSize(), 0.0)))...> sensors_of(
    Types<Models...>);

}  // namespace description

/// All sensors, under the conventions of scenes/sensors/sensor.h.
using Sensors = decltype(sensors_of(description::SensorModels{}));

}  // namespace plumb
