#pragma once

#include <array>

#include "scenes/sensors/perspective.h"

namespace plumb {

/// A pinhole whose picture stands on its head, as it falls on the back wall of a camera obscura.
class Obscura {
public:
    static constexpr bool has_lens = false;

    Obscura(const CameraPose& pose, FilmSize size, double fov_x, double margin)
        : pinhole_(pose, size, fov_x, FovAxis::x, margin), size_(size) {}

    [[nodiscard]] Ray sample_ray(const Point<2>& film, const Point<2>& lens) const;
    [[nodiscard]] double pdf(const Ray& ray) const { return pinhole_.pdf(ray); }
    [[nodiscard]] std::optional<SensorSample> connect(Vec3 from, const Point<2>& lens) const;

private:
    [[nodiscard]] Point<2> turned(const Point<2>& film) const;

    Perspective pinhole_;
    FilmSize size_;
};
static_assert(SensorModel<Obscura>);

namespace description {

struct Obscura {
    double fov_x = 50;  ///< full horizontal angle in degrees

    static constexpr std::array plugins{Plugin{"obscura", "a pinhole camera whose picture stands on its head"}};
    static Obscura load(Properties& properties, const Film& film) { return {load_fov_x(properties, film)}; }
    [[nodiscard]] plumb::Obscura model(const CameraPose& pose, FilmSize size, double margin) const {
        return {pose, size, fov_x, margin};
    }
};

}  // namespace description

}  // namespace plumb
