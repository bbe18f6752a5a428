#include "scenes/sensors/film_plane.h"

#include <fmt/format.h>

#include <numbers>

#include "core/error.h"

namespace plumb {

CameraPose look_at(Vec3 origin, Vec3 target, Vec3 up) {
    const Vec3 way = target - origin, side = cross(way, up);
    if (!(length(way) > 0 && length(side) > 1e-9 * length(way) * length(up)))
        throw Error(
            fmt::format("camera from ({}, {}, {}) to ({}, {}, {}) with up ({}, {}, {}): target must differ from "
                        "the origin and up must not lie along the view",
                        origin.x, origin.y, origin.z, target.x, target.y, target.z, up.x, up.y, up.z));
    const Vec3 forward = normalize(way), right = normalize(side);
    return {origin, right, cross(right, forward), forward};
}

FilmPlane::FilmPlane(FilmSize size, double fov, FovAxis axis, double margin)
    : width_(size.width), height_(size.height), margin_(margin) {
    if (size.width < 1 || size.height < 1)
        throw Error(fmt::format("film of {} x {} pixels: both must be at least 1", size.width, size.height));
    if (!(fov > 0 && fov < 180)) throw Error(fmt::format("field of view of {} degrees: accepted are 0 to 180", fov));
    const auto extent = [&] {
        switch (axis) {
            case FovAxis::x: return width_;
            case FovAxis::y: return height_;
            case FovAxis::diagonal: return std::hypot(width_, height_);
            case FovAxis::smaller: return std::min(width_, height_);
            case FovAxis::larger: return std::max(width_, height_);
        }
        throw Error("unknown axis of the field of view");
    }();
    const double per_pixel = std::tan(fov * std::numbers::pi / 360) / extent;
    half_width_ = per_pixel * width_;
    half_height_ = per_pixel * height_;
}

Vec3 FilmPlane::place(const Point<2>& film) const {
    return {(2 * film[0] / width_ - 1) * half_width_, (1 - 2 * film[1] / height_) * half_height_, 1};
}

std::optional<Point<2>> FilmPlane::film_at(Vec3 towards) const {
    if (!(towards.z > 0)) return {};
    const Point<2> film{(towards.x / towards.z / half_width_ + 1) / 2 * width_,
                        (1 - towards.y / towards.z / half_height_) / 2 * height_};
    const auto within = [&](double x, double extent) { return -margin_ <= x && x < extent + margin_; };
    if (!within(film[0], width_) || !within(film[1], height_)) return {};
    return film;
}

double FilmPlane::pixels_per_area() const {
    return width_ * height_ / (4 * half_width_ * half_height_);
}

}  // namespace plumb
