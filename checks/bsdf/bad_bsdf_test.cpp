// What a model under development does: every defect is refuted with a reason that names it, none ends the process.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "checks/bsdf/gtest.h"
#include "core/error.h"
#include "scenes/bsdfs/conductor.h"
#include "scenes/bsdfs/diffuse.h"
#include "scenes/bsdfs/plastic.h"
#include "scenes/bsdfs/roughconductor.h"

namespace plumb::checks {
namespace {

using testing::HasSubstr;
using U = std::array<double, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

BsdfSubject matte() {
    return subject_of(Diffuse{Spectrum::grey(0.5)});
}
Run some_run() {
    return Run(7, "bad_bsdf", 1e-6);
}
std::string reason_of_values(const BsdfSubject& bsdf) {
    const Verdict verdict = values_are_sound(bsdf, {}, some_run());
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    return verdict.reason;
}

BsdfSubject with_pdf(double value) {
    BsdfSubject bsdf = matte();
    bsdf.pdf = [=](Vec3, Vec3) { return value; };
    return bsdf;
}
BsdfSubject with_eval(double value) {
    BsdfSubject bsdf = matte();
    bsdf.eval = [=](Vec3, Vec3, Transport) { return Spectrum::grey(value); };
    return bsdf;
}
BsdfSubject with_discrete(double value) {
    BsdfSubject bsdf = matte();
    bsdf.discrete = [=](Vec3) { return value; };
    return bsdf;
}
BsdfSubject with_sample(const std::function<void(BsdfSample&)>& change) {
    BsdfSubject bsdf = matte();
    bsdf.sample = [=, sample = bsdf.sample](Vec3 wo, const U& u, Transport transport) {
        auto result = sample(wo, u, transport);
        if (result) change(*result);
        return result;
    };
    return bsdf;
}
BsdfSubject without_samples() {
    BsdfSubject bsdf = matte();
    bsdf.sample = [](Vec3, const U&, Transport) { return std::optional<BsdfSample>{}; };
    return bsdf;
}
BsdfSubject black() {
    BsdfSubject bsdf = without_samples();
    bsdf.pdf = [](Vec3, Vec3) { return 0.0; };
    bsdf.eval = [](Vec3, Vec3, Transport) { return Spectrum{}; };
    bsdf.discrete = {};
    return bsdf;
}

TEST(BadBsdf, EachDefectOfValuesIsNamed) {
    EXPECT_THAT(reason_of_values(with_pdf(nan)), HasSubstr("pdf() is nan (wo 0° "));
    EXPECT_THAT(reason_of_values(with_pdf(-0.1)), HasSubstr("pdf() is -0.1"));
    EXPECT_THAT(reason_of_values(with_pdf(infinity)), HasSubstr("pdf() is inf"));
    EXPECT_THAT(reason_of_values(with_pdf(0)), HasSubstr("where pdf() is 0, so that no sample finds it"));
    EXPECT_THAT(reason_of_values(with_eval(nan)), HasSubstr("eval() is (nan, nan, nan, 0)"));
    EXPECT_THAT(reason_of_values(with_eval(-1)), HasSubstr("eval() is (-1, -1, -1, 0)"));
    EXPECT_THAT(reason_of_values(with_discrete(nan)), HasSubstr("discrete() is nan (wo 0° "));
    EXPECT_THAT(reason_of_values(with_discrete(-5)), HasSubstr("discrete() is -5"));
    EXPECT_THAT(reason_of_values(without_samples()),
                HasSubstr("none of 256 samples scatters, though pdf() integrates to 1 ("));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) { s.wi = s.wi * 2; })), HasSubstr("of length 2 "));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) { s.wi.x = nan; })), HasSubstr("the direction (nan, "));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) { s.pdf = 0; })), HasSubstr("sample() gives the pdf 0"));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) { s.pdf = nan; })), HasSubstr("the pdf nan"));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) { s.eta = 0; })), HasSubstr("the eta 0"));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) { s.weight = Spectrum::grey(infinity); })),
                HasSubstr("the weight (inf, inf, inf, 0)"));
    EXPECT_THAT(reason_of_values(with_sample([](BsdfSample& s) {
                    s.measure = Measure::discrete;
                    s.pdf = 3;
                })),
                HasSubstr("the probability 3"));
}

TEST(BadBsdf, OtherChecksAreNotTriedOnBadValues) {
    const auto verdicts = check_bsdf(with_pdf(nan), {}, some_run());
    ASSERT_EQ(verdicts.size(), 8u);
    for (const auto& [property, verdict] : verdicts)
        EXPECT_EQ(verdict.outcome, property == "values" ? Outcome::refuted : Outcome::undecided) << property;
}

/// Bad values may hide from the samples that values_are_sound() takes: each other check ends by itself, too.
TEST(BadBsdf, EveryCheckEndsByItself) {
    const std::vector<std::pair<std::string, BsdfSubject>> subjects{
        {"pdf nan", with_pdf(nan)},
        {"pdf negative", with_pdf(-1)},
        {"pdf infinite", with_pdf(infinity)},
        {"pdf zero", with_pdf(0)},
        {"pdf huge", with_pdf(1e300)},
        {"eval nan", with_eval(nan)},
        {"eval infinite", with_eval(infinity)},
        {"discrete nan", with_discrete(nan)},
        {"discrete negative", with_discrete(-5)},
        {"discrete infinite", with_discrete(infinity)},
        {"no samples", without_samples()},
        {"wi nan", with_sample([](BsdfSample& s) {
             s.wi = {nan, nan, nan};
         })},
        {"weight nan", with_sample([](BsdfSample& s) { s.weight = Spectrum::grey(nan); })}};
    for (const auto& [name, bsdf] : subjects) {
        const plumb::Run run = some_run();
        const std::vector<Verdict> verdicts{
            samples_follow_pdf(bsdf, {}, run),      pdf_is_inverse_jacobian(bsdf, {}, run),
            weight_is_eval_over_pdf(bsdf, {}, run), masses_match(bsdf, {}, run),
            is_reciprocal(bsdf, {}, run),           radiance_scales_by_eta_squared(bsdf, {}, run),
            conserves_energy(bsdf, {}, run)};
        EXPECT_TRUE(std::ranges::any_of(verdicts, [](const Verdict& v) { return v.outcome == Outcome::refuted; }))
            << name;
    }
}

TEST(BadBsdf, TraitsOutsideTheirRangeAreErrors) {
    EXPECT_THROW(static_cast<void>(check_bsdf(matte(), {.roughness = 0}, some_run())), Error);
    EXPECT_THROW(static_cast<void>(check_bsdf(matte(), {.roughness = nan}, some_run())), Error);
    EXPECT_THROW(static_cast<void>(check_bsdf(matte(), {.eta = -1.5}, some_run())), Error);
    EXPECT_THROW(static_cast<void>(check_bsdf(matte(), {.epsilon = 0.1}, some_run())), Error);
}

TEST(BadBsdf, OfABlackModelNothingIsShown) {
    EXPECT_EQ(values_are_sound(black(), {}, some_run()).outcome, Outcome::undecided);
    for (const auto& [property, verdict] : check_bsdf(black(), {}, some_run()))
        EXPECT_NE(verdict.outcome, Outcome::refuted) << property << ": " << verdict.reason;
}

TEST(BadBsdf, ValuesOfOurModelsAreSound) {
    const auto sound = [](const auto& model) { return holds(values_are_sound(subject_of(model), {}, some_run())); };
    EXPECT_TRUE(sound(Diffuse{Spectrum::grey(0.5)}));
    EXPECT_TRUE(sound(Conductor{{}, Spectrum::grey(1)}));
    EXPECT_TRUE(sound(Plastic(Spectrum::grey(0.5), SmoothCoat(1.5), true)));
    for (const MicrofacetShape shape : {MicrofacetShape::ggx, MicrofacetShape::beckmann})
        for (const double alpha : {1e-4, 1e-2, 1.0})
            EXPECT_TRUE(sound(RoughConductor{{shape, alpha}, {}, Spectrum::grey(1)}));
}

TEST(BadBsdf, GtestTellsEveryPropertyThatFails) {
    const testing::AssertionResult result = holds(check_bsdf(without_samples(), {}, trial()));
    EXPECT_FALSE(result);
    EXPECT_THAT(result.message(), HasSubstr("\n  values: refuted: none of 256 samples scatters"));
    EXPECT_THAT(result.message(), HasSubstr("\n  energy: undecided: not tried"));
    EXPECT_THAT(result.message(), HasSubstr("PLUMB_SEED="));
    EXPECT_TRUE(holds(check_bsdf(matte(), {}, trial())));
}

}  // namespace
}  // namespace plumb::checks
