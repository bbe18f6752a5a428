#include "scenes/bsdfs/rough_transmittance.h"

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/fresnel.h"

namespace plumb {
namespace {

// ∫ F D G1(wo) G1(wi)/(4 wo.z) dwi over the upper hemisphere, by the midpoint rule over the visible normals.
// Along the first axis normals tilt, and towards grazing light the integrand ends at the horizon: it needs the points.
double reflected(const Microfacets& facets, double eta, double cosine) {
    const Vec3 wo{std::sqrt(1 - cosine * cosine), 0, cosine};
    constexpr int along = 192, around = 16;
    double sum = 0;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const Vec3 m = facets.sample_visible(wo, {(i + 0.5) / along, (j + 0.5) / around});
            const Vec3 wi = mirrored(wo, m);
            if (wi.z > 0) sum += fresnel_dielectric(dot(wo, m), eta).reflectance * facets.g1(wi, m);
        }
    return sum / (along * around);
}

// The cosine of node k of n.
double node(std::size_t k, std::size_t n) {
    const double t = static_cast<double>(k) / static_cast<double>(n);
    return t * t;
}

}  // namespace

RoughTransmittance::RoughTransmittance(const Microfacets& facets, double eta) : facets_(facets), eta_(eta) {
    for (std::size_t k = 0; k <= nodes; ++k) values_[k] = 1 - reflected(facets, eta, std::max(node(k, nodes), 1e-10));
    double mean = 0;  // 2 ∫ T c dc, exact for the table's straight pieces
    for (std::size_t k = 0; k < nodes; ++k) {
        const double a = node(k, nodes), b = node(k + 1, nodes);
        mean += (b - a) * (values_[k] * (2 * a + b) + values_[k + 1] * (a + 2 * b)) / 3;
    }
    returned_ = 1 - mean / (eta * eta);
}

double RoughTransmittance::at(double cosine) const {
    const std::size_t k = std::min(nodes - 1, static_cast<std::size_t>(std::sqrt(cosine) * nodes));
    const double a = node(k, nodes), b = node(k + 1, nodes);
    return values_[k] + (values_[k + 1] - values_[k]) * (cosine - a) / (b - a);
}

}  // namespace plumb
