#include "checks/bsdf/check_bsdf.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scenes/bsdfs/dielectric.h"
#include "scenes/bsdfs/roughconductor.h"
#include "scenes/bsdfs/roughdielectric.h"

namespace plumb::checks {
namespace {

void expect_all_hold(const std::vector<NamedVerdict>& verdicts) {
    for (const auto& [property, verdict] : verdicts)
        EXPECT_EQ(verdict.outcome, Outcome::holds) << property << ": " << verdict.reason;
}

/// Somebody else's surface: no transport, no word about discrete lobes.
struct Matte {
    double albedo = 0.5;
    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const { return Spectrum::grey(albedo * pdf(wo, wi)); }
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const { return wo.z > 0 && wi.z > 0 ? wi.z * std::numbers::inv_pi : 0; }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const {
        if (!(wo.z > 0)) return {};
        const double r = std::sqrt(u[1]), phi = 2 * std::numbers::pi * u[2];
        const Vec3 wi{r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u[1])};
        return BsdfSample{wi, Spectrum::grey(albedo), pdf(wo, wi), Measure::solid_angle, 1, 1};
    }
};

TEST(CheckBsdf, HoldsForASomebodyElsesModel) {
    expect_all_hold(check_bsdf(Matte{}));
}

TEST(CheckBsdf, HoldsForSmoothAndRoughGlass) {
    expect_all_hold(check_bsdf(Dielectric{1.5}, {1, 1.5, true}));
    expect_all_hold(check_bsdf(RoughDielectric{{MicrofacetShape::ggx, 0.2}, 1.5}, {0.2, 1.5}));
}

TEST(CheckBsdf, HoldsForNarrowLobes) {
    expect_all_hold(check_bsdf(RoughConductor{{MicrofacetShape::beckmann, 1e-4}, {}, Spectrum::grey(1)}, {1e-4}));
}

TEST(CheckBsdf, NamesTheDefect) {
    struct TooBright : Matte {
        TooBright() : Matte{1.01} {}
    };
    for (const auto& [property, verdict] : check_bsdf(TooBright{}))
        EXPECT_EQ(verdict.outcome, property == "energy" ? Outcome::refuted : Outcome::holds) << property;
}

}  // namespace
}  // namespace plumb::checks
