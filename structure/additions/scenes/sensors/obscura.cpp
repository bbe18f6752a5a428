#include "scenes/sensors/obscura.h"

namespace plumb {

Ray Obscura::sample_ray(const Point<2>& film, const Point<2>& lens) const {
    return pinhole_.sample_ray(turned(film), lens);
}

std::optional<SensorSample> Obscura::connect(Vec3 from, const Point<2>& lens) const {
    std::optional<SensorSample> seen = pinhole_.connect(from, lens);
    if (seen) seen->film = turned(seen->film);
    return seen;
}

Point<2> Obscura::turned(const Point<2>& film) const {
    return {size_.width - film[0], size_.height - film[1]};
}

}  // namespace plumb
