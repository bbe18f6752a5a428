#include "verification/pictures/weighted_pixels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/moments.h"
#include "core/random.h"

namespace plumb {
namespace {

Picture flat(double variance, double degrees) {
    Picture picture{.width = 16, .height = 12, .channels = {"Y"}};
    picture.mean.assign(16 * 12, 5);
    picture.variance.assign(16 * 12, variance);
    picture.degrees = degrees;
    return picture;
}

double sum_of(const WeightedPixels& pixels) {
    double sum = 0;
    for (const PixelWeight& pixel : pixels) sum += pixel.weight;
    return sum;
}

TEST(WeightedPixels, ShareAreasWithARectangle) {
    const Picture picture = flat(1, 15);
    const WeightedPixels film = pixels_under(picture, 0, 0, 16, 12);
    ASSERT_EQ(film.size(), 16U * 12U);
    for (const PixelWeight& pixel : film) EXPECT_NEAR(pixel.weight, 1.0 / (16 * 12), 1e-15);
    const WeightedPixels part = pixels_under(picture, 1.5, 2, 2, 1.25);  // columns ½, 1, ½; rows 1, ¼
    ASSERT_EQ(part.size(), 6U);
    EXPECT_NEAR(part[0].weight, 0.5 / 2.5, 1e-15);
    EXPECT_NEAR(part[1].weight, 1 / 2.5, 1e-15);
    EXPECT_NEAR(part[4].weight, 0.25 / 2.5, 1e-15);
    EXPECT_NEAR(sum_of(part), 1, 1e-15);
    const WeightedPixels corner = pixels_under(picture, 15.5, 11.5, 1, 1);  // moved inside
    ASSERT_EQ(corner.size(), 1U);
    EXPECT_EQ(corner[0].x, 15);
    EXPECT_EQ(corner[0].y, 11);
}

TEST(WeightedPixels, AreAsSkewedAsSoManyEquals) {
    EXPECT_NEAR(count_of_equals(pixels_under(flat(1, 15), 0, 0, 16, 12)), 16 * 12, 1e-9);
    EXPECT_NEAR(count_of_equals({{0, 0, 1}}), 1, 1e-12);
}

TEST(NoisyChannel, AddsVariancesOfPixels) {
    const Picture picture = flat(4, 15);
    const NoisyChannel channel(picture, 0);
    const DifferenceSums film = channel.sums(pixels_under(picture, 0, 0, 16, 12), 7);
    EXPECT_NEAR(film.a, 5, 1e-12);
    EXPECT_EQ(film.b, 7);
    EXPECT_NEAR(film.variance_a, 4.0 / (16 * 12), 1e-12);
    // The degrees of freedom of a sum of n equal variances are n (ν + 2) − 2.
    EXPECT_NEAR(film.variance_a * film.variance_a / film.square_a - 2, 16 * 12 * 17 - 2, 1e-6);
}

TEST(NoisyChannel, KnowsWhatPixelsHaveInCommonByTheErrorOfTheWholeMean) {
    Picture picture = flat(4, 15);
    const WeightedPixels film = pixels_under(picture, 0, 0, 16, 12), part = pixels_under(picture, 2, 2, 8, 8),
                         point = pixels_under(picture, 2.5, 2.5, 1, 1);
    EXPECT_EQ(NoisyChannel(picture, 0).inflation(film).a, 1);
    for (const double inflation : {3.0, 0.25}) {
        picture.mean_variance = {inflation * 4 / (16 * 12)};
        const NoisyChannel channel(picture, 0);
        EXPECT_NEAR(channel.inflation(film).a, inflation, 1e-12);
        EXPECT_EQ(channel.inflation(film).degrees_a, 15);
        EXPECT_NEAR(channel.inflation(part).a, std::max(1.0, inflation), 1e-12);
        EXPECT_EQ(channel.inflation(point).a, 1);
    }
}

/// Renders whose pixels have one error in common: the variance of the mean over any part is that of a pixel.
TEST(NoisyChannel, KnowsItByTheSpreadOfRenders) {
    std::vector<Image> images;
    Moments spread;
    for (const float error : {-0.5F, 0.25F, 1.F, -0.75F}) {
        images.push_back({16, 12, {"Y"}, std::vector<float>(16 * 12, 5 + error)});
        spread.add(error);
    }
    const Picture picture = picture_of(images, std::vector<std::string>(4, "render"));
    const NoisyChannel channel(picture, 0);
    const WeightedPixels part = pixels_under(picture, 2, 2, 8, 8);
    const Inflation inflation = channel.inflation(part);
    EXPECT_EQ(inflation.degrees_a, 3);
    EXPECT_NEAR(inflation.a * channel.sums(part, 5).variance_a, spread.variance() / 4, 1e-9);
}

}  // namespace
}  // namespace plumb
