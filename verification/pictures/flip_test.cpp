#include "verification/pictures/flip.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/random.h"
#include "verification/pictures/flip_filters.h"

namespace plumb::flip {
namespace {

using testing::DoubleNear, testing::ElementsAre, testing::Each;

auto near(double a, double b, double c, double error) {
    return ElementsAre(DoubleNear(a, error), DoubleNear(b, error), DoubleNear(c, error));
}

// ---- colours

TEST(FlipColour, OpponentsOfLightAreLinearAndComeBack) {
    EXPECT_THAT(opponent_of({0, 0, 0}), near(-16, 0, 0, 1e-12));
    EXPECT_THAT(opponent_of({1, 1, 1}), near(100, 0, 0, 1e-12));
    EXPECT_THAT(opponent_of({0.25, 0.25, 0.25}), near(13, 0, 0, 1e-12));
    // Green: X, Y and Z are 8788810/24577794, /12288897 and /73733382, over white's 0.950428545, 1 and 1.088900371.
    EXPECT_THAT(opponent_of({0, 1, 0}),
                near(116 * 0.71518298 - 16, 500 * (0.37624237 - 0.71518298), 200 * (0.71518298 - 0.10946563), 1e-4));
    EXPECT_THAT(rgb_of(opponent_of({0.1, 0.7, 0.3})), near(0.1, 0.7, 0.3, 1e-12));
    EXPECT_THAT(rgb_of_xyz({0.950428545, 1, 1.088900371}), near(1, 1, 1, 1e-8));
}

TEST(FlipColour, LabIsThatOfTheCie) {
    EXPECT_THAT(lab_of({0.18, 0.18, 0.18}), near(116 * std::cbrt(0.18) - 16, 0, 0, 1e-12));
    EXPECT_THAT(lab_of({0.005, 0.005, 0.005}), near(24389.0 / 27 * 0.005, 0, 0, 1e-12));  // the straight part
    EXPECT_THAT(lab_of({0, 1, 0}), near(87.7347, -86.1827, 83.1793, 0.01));
    EXPECT_THAT(lab_of({0, 0, 1}), near(32.297, 79.1875, -107.8602, 0.02));
}

TEST(FlipColour, DarkColoursAreLessColourful) {
    EXPECT_THAT(hunt_adjusted({50, 20, -40}), near(50, 10, -20, 1e-12));
}

TEST(FlipColour, DistanceIsOfLightnessPlusOfColour) {
    EXPECT_NEAR(hyab({50, 1, 2}, {40, 4, -2}), 10 + 5, 1e-12);
}

TEST(FlipColour, ErrorsAreSpreadOverTheUnitInterval) {
    const double largest = hyab(hunt_adjusted(lab_of({0, 1, 0})), hunt_adjusted(lab_of({0, 0, 1})));
    EXPECT_NEAR(largest, 203.3, 0.2);
    EXPECT_EQ(colour_error(0), 0);
    EXPECT_NEAR(colour_error(largest), 1, 1e-12);
    EXPECT_NEAR(colour_error(largest * std::pow(0.4, 1 / 0.7)), 0.95, 1e-12);
    EXPECT_NEAR(colour_error(largest * std::pow(0.2, 1 / 0.7)), 0.475, 1e-12);
    EXPECT_NEAR(colour_error(largest * std::pow(0.7, 1 / 0.7)), 0.975, 1e-12);
}

// ---- filters

double sum(const Weights& weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

TEST(FlipFilters, BlurAsContrastSensitivityFunctionsDo) {
    for (const auto& [number, scale] : {std::pair{0, 0.0047}, {1, 0.0053}}) {
        const std::vector<Blur> blurs = contrast_sensitivity(number, pixels_per_degree);
        ASSERT_EQ(blurs.size(), 1U);
        const Weights& w = blurs[0].weights;
        ASSERT_EQ(w.size(), 21U);  // three standard deviations of the widest: ⌈3 √(0.04/2)/π · 67.02⌉ = 10
        EXPECT_NEAR(sum(w), 1, 1e-12);
        const double step = std::numbers::pi / pixels_per_degree;
        EXPECT_NEAR(w[12] / w[10], std::exp(-4 * step * step / scale), 1e-12);
        EXPECT_EQ(w[8], w[12]);
    }
    const std::vector<Blur> blue = contrast_sensitivity(2, pixels_per_degree);
    ASSERT_EQ(blue.size(), 2U);
    EXPECT_NEAR(blue[0].share + blue[1].share, 1, 1e-12);
    // The integral of a √(π/b) exp(−π² r²/b) over the plane is a √(b/π).
    const double first = 34.1 * std::sqrt(0.04), second = 13.5 * std::sqrt(0.025);
    EXPECT_NEAR(blue[0].share, first / (first + second), 2e-3);
}

TEST(FlipFilters, OfFeaturesHaveWeightsOfSumOneOfEitherSign) {
    const auto [smooth, edge, point] = feature_filters(pixels_per_degree);
    ASSERT_EQ(smooth.size(), 19U);  // ⌈3 · 0.041 · 67.02⌉ = 9
    EXPECT_NEAR(sum(smooth), 1, 1e-12);
    for (const Weights& weights : {edge, point}) {
        double positive = 0, negative = 0;
        for (const double w : weights) (w > 0 ? positive : negative) += w;
        EXPECT_NEAR(positive, 1, 1e-12);
        EXPECT_NEAR(negative, -1, 1e-12);
    }
    EXPECT_EQ(edge[9], 0);
    EXPECT_NEAR(edge[8], -edge[10], 1e-15);
    EXPECT_LT(point[9], 0);
    const double deviation = 0.041 * pixels_per_degree;  // where the second derivative is 0
    EXPECT_LT(point[9 + static_cast<std::size_t>(deviation)], 0);
    EXPECT_GT(point[10 + static_cast<std::size_t>(deviation)], 0);
}

TEST(FlipFilters, RepeatWhatStandsAtTheBorder) {
    const Plane plane{3, 2, {1, 2, 4, 8, 16, 32}};
    const Weights weights{0.5, 0, 2};
    EXPECT_THAT(along_x(plane, weights).values,
                ElementsAre(0.5 * 1 + 2 * 2, 0.5 * 1 + 2 * 4, 0.5 * 2 + 2 * 4, 4 + 32, 4 + 64, 8 + 64));
    EXPECT_THAT(along_y(plane, weights).values, ElementsAre(0.5 + 16, 1 + 32, 2 + 64, 0.5 + 16, 1 + 32, 2 + 64));
}

// ---- pictures

Shown constant(const Triple& rgb) {
    return {24, 24, std::vector<Triple>(24 * 24, rgb)};
}

/// Grey, of one value left of the middle and another right of it.
Shown step(double left, double right) {
    Shown shown = constant({left, left, left});
    for (std::size_t k = 0; k < shown.rgb.size(); ++k)
        if (k % 24 >= 12) shown.rgb[k] = {right, right, right};
    return shown;
}

TEST(Flip, OfConstantsIsTheColoursError) {
    EXPECT_THAT(errors_of(constant({0.3, 0.6, 0.1}), constant({0.3, 0.6, 0.1})), Each(0.0));
    EXPECT_THAT(errors_of(constant({0, 1, 0}), constant({0, 0, 1})), Each(DoubleNear(1, 1e-9)));
    // Greys of 1/4 and 1/2: ΔL = 116 (∛½ − ∛¼).
    const double expected = colour_error(116 * (std::cbrt(0.5) - std::cbrt(0.25)));
    EXPECT_NEAR(expected, 0.452, 1e-3);
    EXPECT_THAT(errors_of(constant({0.5, 0.5, 0.5}), constant({0.25, 0.25, 0.25})), Each(DoubleNear(expected, 1e-8)));
}

/// At both pixels beside a step of height h the filter of edges answers h: all of its positive weights, or all negative
/// ones, lie on one side, and that of the pixel itself is 0. The filter of points answers less.
TEST(Flip, OfAnEdgeIsMoreThanItsColours) {
    const double low = 0.2, high = 0.7;
    const Weights w = contrast_sensitivity(0, pixels_per_degree)[0].weights;
    double right_of_it = low;  // the light that the eye resolves at the first pixel of the right half
    for (std::size_t i = 10; i < w.size(); ++i) right_of_it += (high - low) * w[i];
    const auto lightness = [](double y) { return 116 * std::cbrt(y) - 16; };
    const double colour = colour_error(lightness(right_of_it) - lightness(low));
    const double expected = std::pow(colour, 1 - std::sqrt((high - low) / std::numbers::sqrt2));
    const std::vector<double> errors = errors_of(constant({low, low, low}), step(low, high));
    EXPECT_NEAR(errors[12 * 24 + 12], expected, 1e-9);
    EXPECT_GT(expected, 1.2 * colour);
}

TEST(Flip, IsBetweenNoneAndOne) {
    RandomStream random(1, stream_id("flip"), 0);
    const auto noise = [&] {
        Shown shown = constant({});
        for (Triple& rgb : shown.rgb) rgb = {random.uniform(), random.uniform(), random.uniform()};
        return shown;
    };
    for (const double error : errors_of(noise(), noise())) {
        EXPECT_GE(error, 0);
        EXPECT_LE(error, 1);
    }
}

TEST(HdrFlip, ExposesFromTheBrightestPixelToTheMedian) {
    const auto luminances = [](const std::vector<double>& values) {
        std::vector<Triple> rgb;
        for (const double v : values) rgb.push_back({v, v, v});
        return exposures_of(rgb);
    };
    const std::vector<double> exposures = luminances({6, 1, 1, 1, 0.1});
    ASSERT_EQ(exposures.size(), 3U);  // ⌈log2 6⌉
    EXPECT_NEAR(tone_mapped(6 * std::exp2(exposures.front())), 0.85, 1e-9);
    EXPECT_NEAR(tone_mapped(std::exp2(exposures.back())), 0.85, 1e-9);
    EXPECT_NEAR(exposures[1], (exposures[0] + exposures[2]) / 2, 1e-12);
    EXPECT_EQ(luminances({1, 1, 1}).size(), 2U);
    EXPECT_NEAR(luminances({4, 1, 2, 3}).back() - luminances({1}).back(), -std::log2(2.5), 1e-12);
    EXPECT_THAT(luminances({0, 0, 0, 0, 2, 4, 8}), testing::SizeIs(2));  // of 2, 4, 8: one stop
    EXPECT_THAT(luminances({0, 0}), Each(0.0));
}

TEST(HdrFlip, TonesAreThoseOfAces) {
    EXPECT_EQ(tone_mapped(0), 0);
    // At exposure 0 of the fit, x = 0.6: (2.51 · 0.36 + 0.03 · 0.6)/(2.43 · 0.36 + 0.59 · 0.6 + 0.14).
    EXPECT_NEAR(tone_mapped(1), 0.9216 / 1.3688, 1e-12);
    EXPECT_EQ(tone_mapped(1e30), 1);
}

// ---- measures

Picture picture(double value, std::vector<std::string> channels = {"R", "G", "B"}) {
    Picture picture{.width = 24, .height = 24, .channels = std::move(channels)};
    picture.mean.assign(24 * 24 * picture.channels.size(), value);
    picture.variance.assign(picture.mean.size(), 0);
    return picture;
}

TEST(FlipErrors, AreNoneForEqualPictures) {
    for (const ErrorMeasure& error : flip_errors_of(picture(0.4), picture(0.4))) {
        EXPECT_EQ(error.value, 0) << error.name;
        EXPECT_TRUE(std::isnan(error.interval.low));
    }
}

TEST(FlipErrors, SeeBeyondWhiteInHighDynamicRangeAlone) {
    const std::vector<ErrorMeasure> errors = flip_errors_of(picture(3), picture(6));
    EXPECT_EQ(errors[0].name, "FLIP");
    EXPECT_EQ(errors[0].value, 0);
    EXPECT_EQ(errors[1].name, "HDR-FLIP");
    EXPECT_GT(errors[1].value, 0.1);
}

TEST(FlipErrors, LeaveOutPixelsThatAreNotFinite) {
    Picture a = picture(0.25), b = picture(0.5);
    const double whole = flip_errors_of(a, b)[0].value;
    for (std::size_t c = 0; c < 3; ++c) a.mean[a.at(23, 23, c)] = std::nan("");
    EXPECT_NEAR(flip_errors_of(a, b)[0].value, whole, 0.02);
}

TEST(FlipErrors, TakeGreyAndXyz) {
    EXPECT_NEAR(flip_errors_of(picture(0.25, {"Y"}), picture(0.5, {"Y"}))[0].value,
                flip_errors_of(picture(0.25), picture(0.5))[0].value, 1e-12);
    const auto white = [](double y) {
        Picture p = picture(y, {"X", "Y", "Z"});
        for (std::size_t k = 0; k < p.mean.size(); k += 3) p.mean[k] *= 0.950428545, p.mean[k + 2] *= 1.088900371;
        return p;
    };
    EXPECT_NEAR(flip_errors_of(white(0.25), white(0.5))[0].value, flip_errors_of(picture(0.25), picture(0.5))[0].value,
                1e-6);
}

}  // namespace
}  // namespace plumb::flip
