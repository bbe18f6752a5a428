// A camera obscura there and back.

#include <cmath>
#include <functional>

#include "scenes/sensors/obscura.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

constexpr FilmSize size{64, 48};

/// Where on the film a point of the scene is seen.
using Seen = std::function<Point<2>(Vec3 from)>;

Verdict returns(const Seen& seen, const Run& run) {
    const Obscura sensor(look_at({1, 2, 3}, {0, 0, 0}, {0, 1, 0}), size, 50, 0);
    std::vector<BoundedCase> cases;
    RandomStream random = run.random(0);
    for (int i = 0; i < 1000; ++i) {
        const double x = size.width * random.uniform(), y = size.height * random.uniform();
        const Ray ray = sensor.sample_ray({x, y}, {});
        const Point<2> film = seen(ray.origin + 3 * ray.direction);
        cases.push_back({fmt::format("({}, {}) returns to ({}, {})", x, y, film[0], film[1]),
                         std::hypot(film[0] - x, film[1] - y)});
    }
    return within_bound(cases, 1e-9, "pixels");
}

template <class Sensor>
Point<2> seen_by(const Sensor& sensor, Vec3 from) {
    const auto sample = sensor.connect(from, {});
    return sample ? sample->film : Point<2>{HUGE_VAL, HUGE_VAL};
}

}  // namespace

void add_film_obscura(Catalogue& catalogue) {
    const CameraPose pose = look_at({1, 2, 3}, {0, 0, 0}, {0, 1, 0});
    catalogue.add({.id = "camera/obscura/there-and-back",
                   .statement = "A camera obscura sees the points of a film point's ray at that film point.",
                   .source = "ours, scenes/sensors/obscura.h",
                   .kind = Kind::bounded,
                   .trial = {returns,
                             [pose](Vec3 from) { return seen_by(Obscura(pose, size, 50, 0), from); },
                             {{"upright", "points are seen where an upright camera sees them",
                               [pose](Vec3 from) { return seen_by(Perspective(pose, size, 50), from); }}}}});
}

}  // namespace plumb::suites
