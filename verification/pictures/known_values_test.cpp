#include "verification/pictures/known_values.h"

#include <gmock/gmock.h>

#include <limits>

#include "verification/evidence/distributions.h"
#include "verification/pictures/synthetic_render.h"

namespace plumb {
namespace {

using testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One channel whose value is x + 10 y at the centre of pixel (x, y).
Picture slope(double variance, double degrees) {
    Picture picture{.width = 32, .height = 32, .channels = {"Y"}};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) picture.mean.push_back(x + 0.5 + 10 * (y + 0.5));
    picture.variance.assign(picture.mean.size(), variance);
    picture.degrees = degrees;
    return picture;
}

CheckedValue checked(const Picture& picture, const KnownValue& known, const CheckSettings& settings = {}) {
    return check(picture, std::vector{known}, settings).values.at(0);
}

TEST(KnownValues, BetweenPixelsAreMeansOfThose) {
    const Picture picture = slope(4, 15);
    for (const auto& [x, y] : {std::pair{4.5, 7.5}, {5.0, 7.5}, {4.25, 7.75}}) {
        const CheckedValue value = checked(picture, {.x = x, .y = y, .value = {x + 10 * y}});
        EXPECT_NEAR(value.found.difference, 0, 1e-12);
    }
    // Shares 1/2 and 1/2; 3/16, 9/16, 1/16, 3/16. Of a single variance the degrees of freedom are its own.
    EXPECT_NEAR(checked(picture, {.x = 4.5, .y = 7.5, .value = {1}}).found.standard_error, 2, 1e-12);
    EXPECT_NEAR(checked(picture, {.x = 5, .y = 7.5, .value = {1}}).found.standard_error, 2 * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(checked(picture, {.x = 4.25, .y = 7.75, .value = {1}}).found.standard_error, 2 * 10.0 / 16, 1e-12);
    EXPECT_NEAR(checked(picture, {.x = 4.5, .y = 7.5, .value = {1}}).found.degrees, 15, 1e-12);
    // At an edge the square is moved inside.
    EXPECT_NEAR(checked(picture, {.x = 0, .y = 32, .value = {1}}).found.a, 0.5 + 315, 1e-12);
}

/// The cases of a value 100 with delta 1: is the deviation allowed, and are the errors small enough to tell?
TEST(KnownValues, AreHeldToDelta) {
    const auto state = [](double value, double sigma, double degrees, double error = 0) {
        Picture picture = slope(sigma * sigma, degrees);
        std::ranges::fill(picture.mean, value);
        return checked(picture, {.x = 8.5, .y = 8.5, .value = {100}, .error = error}).state;
    };
    EXPECT_EQ(state(100.5, 0.1, 15), TileState::same);
    EXPECT_EQ(state(100.5, 0.5, 15), TileState::too_noisy);
    EXPECT_EQ(state(102, 0.1, 15), TileState::differs);
    EXPECT_EQ(state(102, 0.5, 15), TileState::too_noisy);
    EXPECT_EQ(state(100.9, 0, infinity), TileState::same);
    EXPECT_EQ(state(101.1, 0, infinity), TileState::differs);
    EXPECT_EQ(state(101.1, 0, 15), TileState::differs);
    EXPECT_EQ(state(101.1, 0, 1), TileState::no_variance);  // two renders that happen to agree
    // What is known is only known within an error.
    EXPECT_EQ(state(101.1, 0, infinity, 0.2), TileState::too_noisy);
    EXPECT_EQ(state(101.3, 0, infinity, 0.2), TileState::differs);
    EXPECT_EQ(state(100, 0, infinity, 1.5), TileState::poorly_known);
    EXPECT_EQ(state(102.6, 0, infinity, 1.5), TileState::differs);
    EXPECT_EQ(state(NAN, 0.1, 15), TileState::no_pixels);
}

TEST(KnownValues, OverRectanglesAreMeans) {
    const Picture picture = slope(4, 15);
    // The film's mean is at its middle; that of a rectangle likewise.
    const CheckedValue film = checked(picture, {.x = 16, .y = 16, .value = {176}, .width = 32, .height = 32});
    EXPECT_NEAR(film.found.difference, 0, 1e-9);
    EXPECT_NEAR(film.found.standard_error, 2.0 / 32, 1e-12);
    EXPECT_EQ(film.state, TileState::same);
    const CheckedValue part = checked(picture, {.x = 7, .y = 4, .value = {47}, .width = 2, .height = 6});
    EXPECT_NEAR(part.found.difference, 0, 1e-9);
    EXPECT_EQ(checked(picture, {.x = 16, .y = 16, .value = {180}, .width = 32, .height = 32}).state,
              TileState::differs);
}

TEST(KnownValues, DistrustPixelsThatMayHaveMissedPaths) {
    Picture picture = slope(0, 15);
    const auto state = [&](double value) { return checked(picture, {.x = 8.5, .y = 8.5, .value = {value}}).state; };
    const std::size_t pixel = picture.at(8, 8, 0);
    std::ranges::fill(picture.mean, 0);
    EXPECT_EQ(state(0), TileState::same);
    EXPECT_EQ(state(1), TileState::no_variance);  // black: no path came
    picture.mean[pixel] = 1;
    EXPECT_EQ(state(1), TileState::same);
    EXPECT_EQ(state(1.1), TileState::differs);
    picture.variance[pixel + 1] = 0.1;  // there is noise hereabouts
    EXPECT_EQ(state(1), TileState::same);
    EXPECT_EQ(state(1.1), TileState::no_variance);
}

/// One replicate of 160 has a spike, so that most pixels show little variance: none may hold.
TEST(KnownValues, DoNotHoldWhereSpikesAreRare) {
    Picture picture = slope(1e-4, 159);
    std::ranges::fill(picture.mean, 100);
    for (std::size_t k = 0; k < picture.mean.size(); k += 5) {  // one standard error high
        picture.mean[k] = 100.1;
        picture.variance[k] = 1e-2;
    }
    const CheckedValue value = checked(picture, {.x = 8.5, .y = 8.5, .value = {100}}, {.delta = 0.0011});
    ASSERT_EQ(value.found.standard_error, 0.01);  // delta is 11 of them
    EXPECT_EQ(value.state, TileState::heavy_tails);
}

TEST(KnownValues, PValuesAreStudentsOfTheExcessOverDelta) {
    const CheckedValue value = checked(slope(4, 15), {.x = 4.5, .y = 7.5, .value = {100}});
    // No skewness is seen where neighbours differ linearly.
    EXPECT_NEAR(value.found.p_value, student_two_sided_tail((100 - 79.5 - 1) / 2, 15), 1e-9);
}

TEST(KnownValues, OfBlackThatIsKnownOnlyRoughlyAreUndecided) {
    Picture picture = slope(0, infinity);
    std::ranges::fill(picture.mean, 0);
    const auto verdict = [&](double error) {
        return check(picture, std::vector{KnownValue{.name = "a", .x = 4.5, .y = 4.5, .value = {0}, .error = error}})
            .verdict;
    };
    EXPECT_EQ(verdict(0).outcome, Outcome::holds);
    EXPECT_EQ(verdict(0.1).outcome, Outcome::undecided);
    EXPECT_THAT(verdict(0.1).reason, HasSubstr("Y of a (its known value is less certain than delta)"));
}

TEST(KnownValues, ThatAreZeroAreRelativeToTheOthers) {
    Picture picture = slope(0, infinity);
    std::ranges::fill(picture.mean, 0.25);
    EXPECT_NEAR(checked(picture, {.x = 4.5, .y = 4.5, .value = {0}}).found.delta, 0.01 * 0.25, 1e-12);
    picture = {.width = 1, .height = 1, .channels = {"R", "G"}, .mean = {3, 4}, .variance = {0, 0}};
    EXPECT_NEAR(check(picture, std::vector{KnownValue{.x = 0.5, .y = 0.5, .value = {2, 0}}}).values[1].found.delta,
                0.01 * 2, 1e-12);
}

class Renders : public testing::Test {
protected:
    /// 16 values of a picture that is 1, 2, 4 everywhere.
    ValuesCheck of(std::uint64_t seed, double brighter, const CheckSettings& settings) const {
        const SyntheticRender render{.samples = 25,
                                     .truth =
                                         [=](int, int) {
                                             return SyntheticRender::Colour{brighter, 2 * brighter, 4};
                                         },
                                     .law = exponential_noise};
        std::vector<KnownValue> known;
        for (int i = 0; i < 16; ++i) known.push_back({"value", "", 1.0 + 2 * i, 4.5 + i, {1, 2, 4}});
        const std::vector<Image> images{render(seed)};
        return check(picture_of(images, std::vector<std::string>{"a"}), known, settings);
    }
};

TEST_F(Renders, OfTheTruthHoldAndBrighterOnesAreRefuted) {
    // Standard errors of 5 %, 3.5 % between two pixels.
    EXPECT_EQ(of(1, 1, {.delta = 0.4}).verdict.outcome, Outcome::holds);
    EXPECT_EQ(of(1, 1, {.delta = 0.01}).verdict.outcome, Outcome::undecided);
    const ValuesCheck wrong = of(1, 2, {.delta = 0.2});
    EXPECT_EQ(wrong.verdict.outcome, Outcome::refuted);
    EXPECT_THAT(wrong.verdict.reason, HasSubstr("values are wrong, most of all"));
    for (const CheckedValue& value : wrong.values)
        EXPECT_FALSE(value.state == TileState::differs && value.channel == 2);
}

/// 16 values of 5 % each know their mean to 1 % or so.
TEST_F(Renders, HoldTogetherWhereEachValueIsTooNoisy) {
    int held = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const ValuesCheck found = of(seed, 1, {.delta = 0.06});
        ASSERT_EQ(found.together.size(), 3U);
        EXPECT_EQ(found.together[1].values, 16U);
        EXPECT_NEAR(found.together[1].found.standard_error, 0.05 / 4 * std::sqrt(0.5), 0.002);
        held += found.verdict.outcome == Outcome::holds;
        if (found.verdict.outcome == Outcome::holds) {
            EXPECT_THAT(found.verdict.reason, HasSubstr("together all 48 values are as known"));
        }
    }
    EXPECT_GE(held, 9);
}

TEST_F(Renders, AreRefutedTogetherWhereNoValueIsAlone) {
    const ValuesCheck found = of(1, 1.1, {.delta = 0.02});
    EXPECT_EQ(found.verdict.outcome, Outcome::refuted);
    EXPECT_THAT(found.verdict.reason, testing::StartsWith("together 16 values are wrong: their mean of R is +"));
    EXPECT_EQ(found.together[2].state == TileState::differs, false);
}

TEST_F(Renders, OnTheEdgeOfDeltaHoldTogetherAtMostAtBeta) {
    std::uint64_t held = 0;
    constexpr int runs = 60;
    for (std::uint64_t seed = 1; seed <= runs; ++seed)
        held += of(seed, 1.06, {.beta = 0.05, .delta = 0.06}).together[0].state == TileState::same;
    EXPECT_LT(clopper_pearson(held, runs, 1e-3).low, 0.05);
}

TEST_F(Renders, SayHowManySamplesWouldDecide) {
    const ValuesCheck few = of(1, 1, {.delta = 0.01});
    EXPECT_THAT(few.verdict.reason, testing::ContainsRegex("about [0-9]+ times as many samples would decide it"));
    double factor = 0;
    for (const CheckedTogether& together : few.together) factor = std::fmax(factor, together.found.more_samples);
    EXPECT_GT(factor, 6);
    EXPECT_LT(factor, 40);  // (3.6 · 0.9)² = 10
}

/// At the edge of what is allowed, in every value: Holm's bound on refuting any is reached at most.
TEST_F(Renders, OnTheEdgeOfDeltaAreRefutedAtMostAtTheLevel) {
    int refuted = 0;
    constexpr int runs = 200;
    for (std::uint64_t seed = 1; seed <= runs; ++seed)
        refuted += of(seed, 1.2, {.alpha = 0.1, .delta = 0.2}).verdict.outcome == Outcome::refuted;
    EXPECT_LE(refuted, 38);  // of 20 expected at most, with probability 1e-4 more
}

}  // namespace
}  // namespace plumb
