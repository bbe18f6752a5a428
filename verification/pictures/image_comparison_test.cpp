#include "verification/pictures/image_comparison.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/error.h"
#include "verification/evidence/distributions.h"
#include "verification/pictures/synthetic_render.h"

namespace plumb {
namespace {

using testing::HasSubstr;

SyntheticRender::Colour gradient(int x, int y) {
    return {0.2 + 0.02 * x, 0.5, 0.1 + 0.01 * y};
}

SyntheticRender exponential(int edge = 32, int replicates = 16) {
    return {.width = edge,
            .height = edge,
            .replicates = replicates,
            .samples = 4,
            .truth = gradient,
            .law = exponential_noise};
}

Picture picture(const Image& image) {
    return picture_of(std::vector{image}, std::vector<std::string>{"image"});
}

ImageComparison compared(const Image& a, const Image& b, const ComparisonSettings& settings = {}) {
    return compare(picture(a), picture(b), settings);
}

/// A lower bound of how often honest pairs are refuted, over alpha.
double false_alarms(const SyntheticRender& one, const SyntheticRender& other, double alpha, std::uint64_t pairs) {
    std::uint64_t refuted = 0;
    for (std::uint64_t i = 0; i < pairs; ++i)
        refuted += compared(one(2 * i + 1), other(2 * i + 2), {.alpha = alpha}).verdict.outcome == Outcome::refuted;
    return clopper_pearson(refuted, pairs, 1e-3).low / alpha;
}

double false_alarms(const SyntheticRender& render, double alpha = 0.05) {
    return false_alarms(render, render, alpha, 300);
}

TEST(ImageComparison, RefutesHonestPairsNoMoreOftenThanAlpha) {
    for (const int replicates : {2, 4, 16}) EXPECT_LT(false_alarms(exponential(32, replicates)), 1) << replicates;
}

TEST(ImageComparison, RefutesHonestPairsOfUnlikeNoiseNoMoreOftenThanAlpha) {
    SyntheticRender quiet = exponential(), spiky = exponential();
    quiet.law = [](RandomStream& random, int, int) { return 0.9 + 0.2 * random.uniform(); };
    spiky.law = spiky_noise(200, 50);
    EXPECT_LT(false_alarms(exponential(32, 4), quiet, 0.05, 300), 1);
    EXPECT_LT(false_alarms(spiky, quiet, 0.05, 300), 1);
    spiky.law = spiky_noise(2000, 400);
    EXPECT_LT(false_alarms(spiky, quiet, 0.05, 300), 1);
    spiky.replicates = 4;
    EXPECT_LT(false_alarms(spiky, spiky, 0.05, 300), 1);
}

/// Each sample spread over 3x3 pixels, as a wide reconstruction filter does.
Image splatted(const Image& image) {
    Image out = image;
    const auto at = [&](int x, int y, std::size_t c) {
        return image.at((x + image.width) % image.width, (y + image.height) % image.height, c);
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 6; ++c) {
                float sum = 0;
                for (int v = -1; v <= 1; ++v)
                    for (int u = -1; u <= 1; ++u) sum += at(x + u, y + v, c);
                out.values[static_cast<std::size_t>(y * image.width + x) * 6 + c] = sum / (c < 3 ? 9 : 81);
            }
    return out;
}

TEST(ImageComparison, SeesWhatFiltersCorrelate) {
    const SyntheticRender render = exponential(64);
    const ImageComparison found = compared(splatted(render(1)), splatted(render(2)));
    EXPECT_EQ(found.correlation.reach, 2);
    EXPECT_NEAR(found.correlation.inflation, 9, 1);
    std::uint64_t refuted = 0;
    for (std::uint64_t i = 0; i < 100; ++i)
        refuted += compared(splatted(render(2 * i)), splatted(render(2 * i + 1)), {.alpha = 0.05}).verdict.outcome ==
                   Outcome::refuted;
    EXPECT_LT(clopper_pearson(refuted, 100, 1e-3).low, 0.05);
    EXPECT_EQ(compared(render(1), render(2)).correlation.reach, 0);
}

TEST(ImageComparison, HoldsWhereNoiseIsLow) {
    SyntheticRender render = exponential();
    render.samples = 400;
    const ImageComparison found = compared(render(1), render(2), {.delta = 0.02});
    EXPECT_EQ(found.verdict.outcome, Outcome::holds);
    EXPECT_EQ(found.errors[0].name, "RMSE");
}

TEST(ImageComparison, IsUndecidedWhereNoiseIsHigh) {
    const ImageComparison found = compared(exponential()(1), exponential()(2));
    EXPECT_EQ(found.verdict.outcome, Outcome::undecided);
    EXPECT_THAT(found.verdict.reason, HasSubstr("not decided"));
}

TEST(ImageComparison, NamesTheTilesThatDiffer) {
    SyntheticRender render = exponential(64), dark = render;
    dark.truth = [](int x, int y) {
        SyntheticRender::Colour c = gradient(x, y);
        if (x >= 16 && x < 24 && y >= 40 && y < 48)
            for (double& v : c) v *= 0.5;
        return c;
    };
    const ImageComparison found = compared(render(1), dark(2));
    EXPECT_EQ(found.verdict.outcome, Outcome::refuted);
    ASSERT_EQ(found.differing.size(), 3U);  // of three channels
    EXPECT_EQ(found.tiles[found.differing[0]].box.x, 16);
    EXPECT_EQ(found.tiles[found.differing[0]].box.y, 40);
    EXPECT_THAT(found.verdict.reason, HasSubstr("the 8x8 pixels at (16, 40)"));
}

TEST(ImageComparison, DoesNotTakeABiasForCorrelation) {
    SyntheticRender render = exponential(), dark = render;
    render.samples = dark.samples = 400;
    dark.truth = [](int x, int y) {
        SyntheticRender::Colour c = gradient(x, y);
        for (double& v : c) v *= x > 11 && y > 7 ? 0.95 : 1;
        return c;
    };
    const ImageComparison found = compared(render(1), dark(2));
    EXPECT_LT(found.correlation.inflation, 2);
    EXPECT_EQ(found.verdict.outcome, Outcome::refuted);
}

TEST(ImageComparison, RefutesSharedSamples) {
    const Image image = exponential()(1);
    const ImageComparison same = compared(image, image);
    EXPECT_EQ(same.verdict.outcome, Outcome::refuted);
    EXPECT_THAT(same.verdict.reason, HasSubstr("too alike"));
}

Image scaled_variance(Image image, float factor) {
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (i % 6 >= 3) image.values[i] *= factor;
    return image;
}

TEST(ImageComparison, RefutesVariancesThatAreTooLarge) {
    const SyntheticRender few = exponential(64, 2), many = exponential(64, 64);
    const ImageComparison found = compared(scaled_variance(few(1), 8), scaled_variance(many(2), 8));
    EXPECT_EQ(found.verdict.outcome, Outcome::refuted);
    EXPECT_THAT(found.verdict.reason, HasSubstr("too alike"));
    EXPECT_GT(compared(few(1), many(2)).alike.p_value, 1e-3);
}

TEST(ImageComparison, TakesNoConstantsForSharedSamples) {
    for (std::uint64_t pair = 0; pair < 20; ++pair) {
        const auto sky = [&](Image image) {  // of 0.7, with what rounding left of its variance
            for (std::size_t i = 0; i < image.values.size(); ++i)
                if (i / 6 % 32 < 24) image.values[i] = i % 6 < 3 ? 0.7f : 1e-15f;
            return image;
        };
        const ImageComparison found = compared(sky(exponential()(2 * pair)), sky(exponential()(2 * pair + 1)));
        EXPECT_GT(found.alike.p_value, 1e-4) << pair;
    }
}

TEST(ImageComparison, TakesNoRoundingForSharedSamples) {
    const auto in_halves = [](Image image) {
        for (float& value : image.values) {
            int exponent = 0;
            const float digits = std::frexp(value, &exponent);
            value = std::ldexp(std::round(std::ldexp(digits, 11)), exponent - 11);
        }
        return image;
    };
    for (const double noise : {3e-5, 3e-4, 3e-3, 3e-2}) {
        SyntheticRender render = exponential(32, 2);
        render.law = [=](RandomStream& random, int, int) { return 1 + noise * (2 * random.uniform() - 1); };
        for (std::uint64_t pair = 0; pair < 10; ++pair) {
            const ImageComparison found = compared(in_halves(render(2 * pair)), in_halves(render(2 * pair + 1)));
            EXPECT_GT(found.alike.p_value, 1e-4) << noise;
        }
    }
}

TEST(ImageComparison, LeavesFirefliesUndecidedAndNamed) {
    SyntheticRender quiet = exponential();
    quiet.samples = 400;
    const Image a = quiet(1);
    Image b = quiet(2);
    // One replicate of sixteen was hit by a path of 1600.
    const std::size_t pixel = (20 * 32 + 20) * 6;
    for (std::size_t c = 0; c < 3; ++c) {
        b.values[pixel + c] += 100;
        b.values[pixel + 3 + c] = 100 * 100;
    }
    const ImageComparison found = compared(a, b, {.delta = 0.02});
    EXPECT_EQ(found.verdict.outcome, Outcome::undecided);
    ASSERT_FALSE(found.undecided.empty());
    const TileTest& tile = found.tiles[found.undecided[0]];
    EXPECT_EQ(tile.state, TileState::heavy_tails);
    EXPECT_EQ(tile.box.x, 16);
}

TEST(ImageComparison, CountsPixelsThatAreNotFinite) {
    SyntheticRender render = exponential();
    render.samples = 400;
    Image b = render(2);
    b.values[0] = std::numeric_limits<float>::quiet_NaN();
    const ImageComparison found = compared(render(1), b, {.delta = 0.02});
    EXPECT_EQ(found.bad_b, 1U);
    EXPECT_EQ(found.verdict.outcome, Outcome::undecided);
    EXPECT_THAT(found.verdict.reason, HasSubstr("0 pixels of a and 1 of b are no finite numbers"));
}

Image flat(float value, float variance) {
    Image image{16, 16, {"Y", "variance.Y"}, {}, {{"plumb:replicates", "16"}}};
    for (int i = 0; i < 256; ++i) {
        image.values.push_back(value);
        image.values.push_back(variance);
    }
    return image;
}

TEST(ImageComparison, OfPicturesWithoutVarianceIsEquality) {
    EXPECT_EQ(compared(flat(1, 0), flat(1, 0)).verdict.outcome, Outcome::holds);
    EXPECT_EQ(compared(flat(1, 0), flat(1.01f, 0)).verdict.outcome, Outcome::refuted);
}

// The pictures are as of a lamp that one integrator sees without noise, and the other but for a rare splat, which shows
// in another place.
TEST(ImageComparison, OfTilesWithoutVarianceAllowsForSpikesThatThePictureHasElsewhere) {
    Image a = flat(1, 0), b = flat(0.998f, 0);
    for (const std::size_t pixel : {3, 40}) b.values[2 * pixel] = 1.25f, b.values[2 * pixel + 1] = 0.0625f;
    const ImageComparison found = compared(a, b, {.tile = 8});
    EXPECT_NE(found.verdict.outcome, Outcome::refuted) << found.verdict.reason;
    EXPECT_EQ(compared(a, flat(0.5f, 0), {.tile = 8}).verdict.outcome, Outcome::refuted);
    for (std::size_t pixel = 128; pixel < 256; ++pixel) b.values[2 * pixel] = 0.9f;  // 51 spikes' worth of light
    EXPECT_EQ(compared(a, b, {.tile = 8}).verdict.outcome, Outcome::refuted);
}

TEST(ImageComparison, DoesNotTrustABlackThatOnlyOneSideSees) {
    const ImageComparison found = compared(flat(0, 0), flat(1, 0.01f));
    EXPECT_EQ(found.verdict.outcome, Outcome::undecided);
    EXPECT_EQ(found.tiles[0].state, TileState::no_variance);
}

TEST(ImageComparison, OfUnlikeSizesIsAnError) {
    EXPECT_THROW((void)compared(exponential(32)(1), exponential(16)(1)), Error);
}

}  // namespace
}  // namespace plumb
