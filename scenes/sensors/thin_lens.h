#pragma once

#include <array>
#include <variant>

#include "scenes/sensors/film_plane.h"
#include "scenes/sensors/perspective.h"
#include "scenes/sensors/sensor.h"

namespace plumb {

/// An ideal lens, a disk: rays from all its points that start at one film point meet in the plane in focus, where the
/// pinhole's ray meets it.
class ThinLens {
public:
    static constexpr bool has_lens = true;

    /// A lens with `focus`, the distance of the plane in focus. Throws Error unless radius and focus are positive and
    /// finite.
    ThinLens(const CameraPose& pose, FilmSize size, double fov, double radius, double focus, FovAxis axis = FovAxis::x,
             double margin = 0);

    [[nodiscard]] Ray sample_ray(const Point<2>& film, const Point<2>& lens) const;
    /// The density per steradian of the ray's direction. The plane in focus is at distance focus/cos, so that dω = cos³
    /// dA/focus², dA = focus² of the plane at 1: as for the pinhole, whatever the point of the lens.
    [[nodiscard]] double pdf(const Ray& ray) const;
    [[nodiscard]] std::optional<SensorSample> connect(Vec3 from, const Point<2>& lens) const;

private:
    [[nodiscard]] Vec3 lens_point(const Point<2>& lens) const;

    CameraPose pose_;
    FilmPlane plane_;
    double radius_, focus_;
};
static_assert(SensorModel<ThinLens>);

namespace description {

/// The sensor `thinlens` of scene files.
struct ThinLens {
    double fov_x = 50;  ///< full horizontal angle in degrees, whatever axis the file spoke of
    double aperture_radius = 0, focus_distance = 1;

    static constexpr std::array plugins{Plugin{"thinlens", "a camera with a lens, in focus at one distance"}};
    static ThinLens load(Properties& properties, const Film& film);
    /// The sensor that it becomes: a pinhole where the radius is 0.
    [[nodiscard]] std::variant<plumb::ThinLens, plumb::Perspective> model(const CameraPose& pose, FilmSize size,
                                                                          double margin) const;
};

}  // namespace description

}  // namespace plumb
