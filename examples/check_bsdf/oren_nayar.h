// Somebody's renderer: a rough diffuse surface with types of its own. Directions stand in the shading frame, z along
// the normal, and leave the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer {

struct Direction {
    double x, y, z;
};
struct Colour {
    double r, g, b;
};

/// [Oren & Nayar 1994, the qualitative model]: sigma is the standard deviation of the facets' slopes in radians.
struct OrenNayar {
    Colour albedo{0.8, 0.6, 0.4};
    double sigma = 0.35;

    [[nodiscard]] Colour f(Direction wo, Direction wi) const {
        if (wo.z <= 0 || wi.z <= 0) return {0, 0, 0};
        const double s = sigma * sigma, a = 1 - s / (2 * (s + 0.33)), b = 0.45 * s / (s + 0.09);
        // cos(φi − φo) sin α tan β with the larger angle α and the smaller one β: the sines' product is in the dot
        const double cosines = std::max(0.0, wo.x * wi.x + wo.y * wi.y) / std::max(wo.z, wi.z);
        const double shape = (a + b * cosines) / std::numbers::pi;
        return {albedo.r * shape, albedo.g * shape, albedo.b * shape};
    }

    /// The density of what sample() chooses, per steradian.
    [[nodiscard]] double pdf(Direction wo, Direction wi) const {
        return wo.z > 0 && wi.z > 0 ? wi.z / std::numbers::pi : 0;
    }
    [[nodiscard]] Direction sample(double u, double v) const { return around_normal(std::sqrt(u), v); }

    static Direction around_normal(double radius, double v) {
        const double angle = 2 * std::numbers::pi * v;
        return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - radius * radius)};
    }
};

/// The same with the mistake that everybody makes once: the square root is forgotten, so that directions crowd at the
/// normal, which pdf() does not know.
struct WrongOrenNayar : OrenNayar {
    [[nodiscard]] Direction sample(double u, double v) const { return around_normal(u, v); }
};

}  // namespace renderer
