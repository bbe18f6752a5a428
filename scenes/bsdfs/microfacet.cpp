#include "scenes/bsdfs/microfacet.h"

#include <boost/math/special_functions/erf.hpp>
#include <numbers>

namespace plumb {
namespace {

using std::numbers::inv_pi, std::numbers::inv_sqrtpi, std::numbers::pi;

double sin_squared(Vec3 w) {
    return w.x * w.x + w.y * w.y;
}

// Directions over the stretched surface, where alpha is 1.
Vec3 stretched(Vec3 w, double alpha) {
    return normalize({alpha * w.x, alpha * w.y, w.z});
}

// wo and a uniform point of the spherical cap of all mirror directions have their half vector among the visible
// normals of a hemisphere [Dupuy & Benyoub 2023, alg. 1]; heights are measured from the cap's top, where 1 − z²
// cancels.
Vec3 visible_ggx(Vec3 wo, const std::array<double, 2>& u) {
    const double depth = u[1] * (1 + wo.z), phi = 2 * pi * u[0];
    const double radius = std::sqrt(std::max(0.0, depth * (2 - depth)));
    return {radius * std::cos(phi) + wo.x, radius * std::sin(phi) + wo.y, (1 - u[1]) * (1 + wo.z)};
}

// The slope x along wo of the visible facets of a Beckmann surface of alpha 1 has density ∝ (z − x s) exp(−x²) for
// x < z/s, where (s, 0, z) is wo [Heitz & d'Eon 2014]. Its integral from −∞, times √π … :
//   C(x) = z erfc(−x)/2 + s exp(−x²)/(2√π).
// Newton's iteration on C(x) = u C(z/s), kept inside a bracket that every step narrows.
double visible_beckmann_slope(double s, double z, double u) {
    const auto integral = [&](double x) { return z * std::erfc(-x) / 2 + s * std::exp(-x * x) * (inv_sqrtpi / 2); };
    constexpr double far = 9;  // exp(−81) is below 2^-53 times any u
    double low = -far, high = s * far > z ? z / s : far;
    const double target = u * integral(high);
    double x = std::min(high, -boost::math::erfc_inv(2 * std::max(u, 0x1p-54)));
    for (int step = 0; step < 80; ++step) {
        const double excess = integral(x) - target;
        (excess > 0 ? high : low) = x;
        const double slope = (z - x * s) * std::exp(-x * x) * inv_sqrtpi;
        double next = x - excess / slope;
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (std::abs(next - x) <= 1e-15 * (1 + std::abs(x))) return next;
        x = next;
    }
    return x;
}

Vec3 visible_beckmann(Vec3 wo, const std::array<double, 2>& u) {
    const double s = std::sqrt(sin_squared(wo));
    const double along = visible_beckmann_slope(s, wo.z, u[0]);
    const double across = -boost::math::erfc_inv(2 * std::clamp(u[1], 0x1p-54, 1 - 0x1p-53));
    const double c = s > 0 ? wo.x / s : 1, sine = s > 0 ? wo.y / s : 0;
    return {-(c * along - sine * across), -(sine * along + c * across), 1};
}

}  // namespace

double Microfacets::d(Vec3 m) const {
    if (!(m.z > 0)) return 0;
    const double a2 = alpha * alpha, s2 = sin_squared(m), z2 = m.z * m.z;
    if (shape == MicrofacetShape::ggx) {
        const double t = a2 * z2 + s2;
        return inv_pi * a2 / (t * t);
    }
    return inv_pi * std::exp(-s2 / (z2 * a2)) / (a2 * z2 * z2);
}

double Microfacets::lambda(Vec3 w) const {
    const double s2 = sin_squared(w), z2 = w.z * w.z;
    if (shape == MicrofacetShape::ggx) {
        const double t = alpha * alpha * s2 / z2;
        return t / (2 * (1 + std::sqrt(1 + t)));
    }
    if (s2 == 0) return 0;
    const double a = std::abs(w.z) / (alpha * std::sqrt(s2));
    return (std::exp(-a * a) * inv_sqrtpi / a - std::erfc(a)) / 2;
}

double Microfacets::g1(Vec3 w, Vec3 m) const {
    if (!(dot(w, m) * w.z > 0)) return 0;
    return 1 / (1 + lambda(w));
}

double Microfacets::visible_pdf(Vec3 wo, Vec3 m) const {
    return g1(wo, m) * std::abs(dot(wo, m)) * d(m) / std::abs(wo.z);
}

Vec3 Microfacets::sample_visible(Vec3 wo, const std::array<double, 2>& u) const {
    const Vec3 over = stretched(wo, alpha);
    const Vec3 m = shape == MicrofacetShape::ggx ? visible_ggx(over, u) : visible_beckmann(over, u);
    return normalize({alpha * m.x, alpha * m.y, m.z});
}

}  // namespace plumb
