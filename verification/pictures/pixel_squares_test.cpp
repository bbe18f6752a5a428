#include "verification/pictures/pixel_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/moments.h"
#include "verification/evidence/distributions.h"
#include "verification/pictures/synthetic_render.h"

namespace plumb {
namespace {

constexpr int edge = 32;

SyntheticRender render(int replicates = 16) {
    return {.width = edge,
            .height = edge,
            .replicates = replicates,
            .samples = 4,
            .truth =
                [](int x, int) {
                    return SyntheticRender::Colour{0.5, 0.5 + 0.01 * x, 1};
                },
            .law = exponential_noise};
}

Picture picture(const Image& image) {
    return picture_of(std::vector{image}, std::vector<std::string>{"image"});
}

SquaresTest alike(const Picture& a, const Picture& b) {
    return too_alike(a, b, grid_of(edge, edge, 8), 1);
}
SquaresTest unlike(const Picture& a, const Picture& b, double allowed = 0) {
    return too_unlike(a, b, grid_of(edge, edge, 8), 1, [=](const PixelBox&, std::size_t) { return allowed; });
}

Picture scaled_variance(Picture picture, double factor) {
    for (double& v : picture.variance) v *= factor;
    return picture;
}

TEST(PixelSquares, OfHonestPairsAreWhatTheirVariancesSay) {
    int small_alike = 0, small_unlike = 0;
    constexpr int pairs = 60;
    Moments low_ratios, high_ratios;
    for (std::uint64_t pair = 0; pair < pairs; ++pair) {
        const int replicates = pair % 2 == 0 ? 16 : 4;
        const Picture a = picture(render(replicates)(2 * pair)), b = picture(render(16)(2 * pair + 1));
        const SquaresTest low = alike(a, b), high = unlike(a, b);
        low_ratios.add(low.ratio);
        high_ratios.add(high.ratio);
        small_alike += low.p_value < 0.01;
        small_unlike += high.p_value < 0.01;
    }
    EXPECT_GT(low_ratios.mean(), 1 - 4 * low_ratios.standard_error());
    EXPECT_LT(high_ratios.mean(), 1 + 4 * high_ratios.standard_error());
    EXPECT_LT(clopper_pearson(static_cast<std::uint64_t>(small_alike), pairs, 1e-3).low, 0.01);
    EXPECT_LT(clopper_pearson(static_cast<std::uint64_t>(small_unlike), pairs, 1e-3).low, 0.01);
}

TEST(PixelSquares, AreSmallerWhereSamplesAreShared) {
    const Picture a = picture(render()(1));
    EXPECT_LT(alike(a, a).ratio, 0.01);
    EXPECT_LT(alike(a, a).p_value, 1e-9);
    EXPECT_LT(alike(scaled_variance(a, 4), scaled_variance(picture(render()(2)), 4)).p_value, 1e-6);
    EXPECT_GT(unlike(a, a).p_value, 0.5);
}

TEST(PixelSquares, AreLargerWhereTexturesDiffer) {
    const Picture a = picture(render()(1));
    Picture checkered = picture(render()(2));
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                checkered.mean[checkered.at(x, y, c)] += (x + y) % 2 == 0 ? 0.15 : -0.15;
    const SquaresTest found = unlike(a, checkered);
    EXPECT_GT(found.ratio, 1.5);
    EXPECT_LT(found.p_value, 1e-6);
    EXPECT_GT(unlike(a, checkered, 0.15).p_value, 1e-3);  // an allowance of as much
    EXPECT_GT(alike(a, checkered).p_value, 0.1);
}

/// A single pixel that differs, as far as it may: it is cut off at 8 of 1024 pixels' terms.
TEST(PixelSquares, LetNoPixelSpeakForAll) {
    const Picture a = picture(render()(1));
    Picture b = picture(render()(2));
    const double before = unlike(a, b).ratio;
    for (std::size_t c = 0; c < 3; ++c) b.mean[b.at(5, 5, c)] += 1e6;
    EXPECT_LT(unlike(a, b).ratio - before, 10.0 / (edge * edge));
    EXPECT_GT(unlike(a, b).p_value, 1e-3);
    EXPECT_LT(alike(a, b).ratio, 1.5);
}

TEST(PixelSquares, SayNothingOfTilesWhereASideShowsNoErrors) {
    const Picture a = picture(render()(1));
    Picture b = picture(render()(2));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                b.variance[b.at(x, y, c)] = 0;
                b.mean[b.at(x, y, c)] = 100;
            }
    EXPECT_GT(unlike(a, b).p_value, 1e-3);
}

}  // namespace
}  // namespace plumb
