#pragma once

#include <array>

#include "scenes/sensors/camera.h"
#include "scenes/sensors/film_plane.h"
#include "scenes/sensors/sensor.h"

namespace plumb {

/// A pinhole camera: everything is in focus.
class Perspective {
public:
    static constexpr bool has_lens = false;

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

namespace description {

/// The sensor `perspective` of scene files.
struct Perspective {
    double fov_x = 50;  ///< full horizontal angle in degrees, whatever axis the file spoke of

    static constexpr std::array plugins{Plugin{"perspective", "a pinhole camera"}};
    static Perspective load(Properties& properties, const Film& film) { return {load_fov_x(properties, film)}; }
    [[nodiscard]] plumb::Perspective model(const CameraPose& pose, FilmSize size, double margin) const {
        return {pose, size, fov_x, FovAxis::x, margin};
    }
};

}  // namespace description

}  // namespace plumb
