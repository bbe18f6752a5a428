#include "scenes/geometry/ball.h"

#include "scenes/description/description.h"

namespace plumb {

namespace {

struct Box {
    Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    void add(Vec3 p) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    void add(const Mesh& mesh) {
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) add(mesh.position(i));
    }
    void add(const description::Sphere& s) {
        const Vec3 reach{s.radius, s.radius, s.radius};
        add(s.center - reach);
        add(s.center + reach);
    }
    void add(const description::Disk& d) {
        for (const double x : {-1., 1.})
            for (const double y : {-1., 1.}) add(d.center + d.axis_x * x + d.axis_y * y);
    }
};

}  // namespace

Ball ball_around(const std::vector<description::Shape>& shapes) {
    Box box;
    for (const description::Shape& shape : shapes)
        std::visit([&](const auto& geometry) { box.add(geometry); }, shape.geometry);
    if (shapes.empty()) return {};
    return {(box.low + box.high) / 2, length(box.high - box.low) / 2};
}

}  // namespace plumb
