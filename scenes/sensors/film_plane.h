#pragma once

#include <optional>

#include "core/point.h"
#include "core/vec3.h"
#include "scenes/film/film_size.h"

namespace plumb {

/// The position of a camera and how it is turned: three orthonormal axes. (Mitsuba's camera matrix has left, up,
/// forward as its columns.)
struct CameraPose {
    Vec3 position, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};

    [[nodiscard]] Frame axes() const { return {right, up, forward}; }
};
/// The pose that looks from origin to target. Throws Error when the two coincide or up is parallel to the view.
CameraPose look_at(Vec3 origin, Vec3 target, Vec3 up);

/// The extent of the film that spans the field of view.
enum class FovAxis { x, y, diagonal, smaller, larger };

/// The film as a window in the plane one unit ahead of a lens: film points, in pixels, against directions.
class FilmPlane {
public:
    /// The window of a film, with fov in degrees, in (0, 180), and margin in pixels, by which filters reach beyond the
    /// film. Throws Error for another fov and for a film of no pixels.
    FilmPlane(FilmSize size, double fov, FovAxis axis, double margin = 0);

    /// The point (x right, y up, z = 1 forward) of the plane.
    [[nodiscard]] Vec3 place(const Point<2>& film) const;
    /// The film point towards (x, y, z); empty behind the lens or outside the film and its margin.
    [[nodiscard]] std::optional<Point<2>> film_at(Vec3 towards) const;
    /// The number of pixels per unit of area of the plane.
    [[nodiscard]] double pixels_per_area() const;
    /// The number of pixels per steradian around a direction at this cosine with the axis: at distance 1/cos, dω = cos³
    /// dA.
    [[nodiscard]] double pixels_per_steradian(double cos) const { return pixels_per_area() / (cos * cos * cos); }

private:
    double width_, height_, margin_, half_width_, half_height_;
};

}  // namespace plumb
