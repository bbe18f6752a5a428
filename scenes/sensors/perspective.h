#pragma once

#include "scenes/sensors/film_plane.h"
#include "scenes/sensors/sensor.h"

namespace plumb {

/// A pinhole: everything is in focus.
class Perspective {
public:
    Perspective(const CameraPose& pose, FilmSize size, double fov, FovAxis axis = FovAxis::x, double margin = 0)
        : pose_(pose), plane_(size, fov, axis, margin) {}

    [[nodiscard]] Ray sample_ray(const Point<2>& film, const Point<2>& lens) const;
    [[nodiscard]] double pdf(const Ray& ray) const;
    [[nodiscard]] std::optional<SensorSample> connect(Vec3 from, const Point<2>& lens) const;

private:
    CameraPose pose_;
    FilmPlane plane_;
};
static_assert(SensorModel<Perspective>);

}  // namespace plumb
