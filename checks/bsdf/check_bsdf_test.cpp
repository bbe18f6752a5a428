#include "checks/bsdf/check_bsdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/directions.h"
#include "checks/bsdf/gtest.h"
#include "scenes/bsdfs/dielectric.h"
#include "scenes/bsdfs/roughconductor.h"
#include "scenes/bsdfs/roughdielectric.h"

namespace plumb::checks {
namespace {

using testing::HasSubstr;

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

/// Of the property's verdict, which must be a refutation.
std::string reason_of(const std::string& property, const std::vector<NamedVerdict>& verdicts) {
    const auto found = std::ranges::find(verdicts, property, &NamedVerdict::property);
    EXPECT_EQ(found->verdict.outcome, Outcome::refuted) << property;
    return found->verdict.reason;
}

TEST(CheckBsdf, TellsTheLikelyCause) {
    struct PerHalfVector : RoughConductor {
        PerHalfVector() : RoughConductor{{MicrofacetShape::ggx, 0.2}, {}, Spectrum::grey(1)} {}
        [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const {
            return wo.z > 0 && wi.z > 0 ? RoughConductor::pdf(wo, wi) * 4 * dot(wo, normalize(wo + wi)) : 0;
        }
    };
    struct WithoutCosine : Matte {
        [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const {
            return wi.z > 0 ? Matte::eval(wo, wi) * (1 / wi.z) : Spectrum();
        }
    };
    struct Halved : Matte {
        [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const { return Matte::pdf(wo, wi) / 2; }
    };
    EXPECT_THAT(reason_of("pdf", check_bsdf(PerHalfVector{}, {0.2})),
                HasSubstr("likely cause: pdf() is 4 (wo·h) times 1/Jacobian"));
    const auto without = check_bsdf(WithoutCosine{});
    EXPECT_THAT(reason_of("weight", without), HasSubstr("likely cause: holds if eval() is multiplied by |wi.z|"));
    EXPECT_THAT(reason_of("reciprocity", without), HasSubstr("likely cause: holds if eval() is multiplied by |wi.z|"));
    EXPECT_THAT(reason_of("pdf", check_bsdf(Halved{})), HasSubstr("likely cause: pdf() is 0.5 times 1/Jacobian"));
}

TEST(CheckBsdf, FindsFloats) {
    struct Narrow : Matte {
        [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const {
            auto sample = Matte::sample(wo, u);
            if (!sample) return sample;
            for (std::size_t axis = 0; axis < 3; ++axis)
                sample->wi[axis] = static_cast<double>(static_cast<float>(sample->wi[axis]));
            sample->pdf = static_cast<double>(static_cast<float>(pdf(wo, sample->wi)));
            return sample;
        }
    };
    EXPECT_EQ(epsilon_of(subject_of(Matte{}), {}, trial()), 0x1p-53);
    EXPECT_EQ(epsilon_of(subject_of(Narrow{}), {}, trial()), 0x1p-24);
    EXPECT_EQ(epsilon_of(subject_of(Narrow{}), {.epsilon = 0x1p-11}, trial()), 0x1p-11);
}

/// Its directions follow the seed: what is wrong within 2 degrees only is found.
TEST(CheckBsdf, LooksBetweenFixedDirections) {
    struct DarkerFrom44To46 : Matte {
        [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi) const {
            return Matte::eval(wo, wi) * (wo.z > 0.695 && wo.z < 0.719 ? 0.5 : 1);
        }
    };
    EXPECT_EQ(check_directions(plumb::Run(1, "x", 1)), check_directions(plumb::Run(1, "x", 1)));
    EXPECT_NE(check_directions(plumb::Run(1, "x", 1)), check_directions(plumb::Run(2, "x", 1)));
    EXPECT_THAT(reason_of("weight", check_bsdf(DarkerFrom44To46{}, {}, trial())), HasSubstr("for eval()"));
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
