#include "verification/pictures/sum_inflation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/moments.h"
#include "core/random.h"

namespace plumb {
namespace {

constexpr int edge = 64;

/// An error of each pixel, of variance 1 or so.
using Errors = std::vector<double> (*)(RandomStream& random);

double uniform(RandomStream& random) {
    return std::sqrt(12) * (random.uniform() - 0.5);
}
std::vector<double> independent(RandomStream& random) {
    std::vector<double> errors;
    for (int i = 0; i < edge * edge; ++i) errors.push_back(uniform(random));
    return errors;
}
/// Four pixels side by side are one error: sums of such have four times the variance.
std::vector<double> in_fours(RandomStream& random) {
    std::vector<double> errors;
    for (int i = 0; i < edge * edge; ++i) errors.push_back(i % 4 == 0 ? uniform(random) : errors.back());
    return errors;
}
/// Neighbours cancel: sums over pairs are 0 but for a tenth.
std::vector<double> opposed(RandomStream& random) {
    std::vector<double> errors;
    for (int i = 0; i < edge * edge; ++i)
        errors.push_back(i % 2 == 0 ? uniform(random) : -errors.back() + 0.1 * uniform(random));
    return errors;
}
std::vector<double> in_fours_at_the_left(RandomStream& random) {
    std::vector<double> errors = independent(random);
    const std::vector<double> joined = in_fours(random);
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (i % edge < edge / 2) errors[i] = joined[i];
    return errors;
}

Picture renders(int count, Errors errors, std::uint64_t seed) {
    std::vector<Image> images;
    for (int r = 0; r < count; ++r) {
        RandomStream random(seed, stream_id("sum inflation"), static_cast<std::uint64_t>(r));
        Image image{edge, edge, {"Y"}, {}};
        for (const double e : errors(random)) image.values.push_back(static_cast<float>(10 + e));
        images.push_back(std::move(image));
    }
    return picture_of(images, std::vector<std::string>(images.size(), "render"));
}

SumInflations found(const Picture& a, const Picture& b) {
    return inflations_of(a, b, grid_of(edge, edge, 8), {});
}

double mean_of(const SumInflations& found, double Inflation::*side, int first_column = 0, int columns = 8) {
    Moments mean;
    for (std::size_t i = 0; i < found.tiles.size(); ++i)
        if (const int column = static_cast<int>(i % 8) - first_column; column >= 0 && column < columns)
            mean.add(found.tiles[i].*side);
    return mean.mean();
}

TEST(SumInflation, IsASidesOwn) {
    const SumInflations all = found(renders(8, in_fours, 1), renders(8, independent, 2));
    EXPECT_TRUE(all.of_spread);
    EXPECT_NEAR(mean_of(all, &Inflation::a), 4, 0.6);
    EXPECT_NEAR(mean_of(all, &Inflation::b), 1, 0.15);
    EXPECT_NEAR(all.picture[0].a, 4, 1.5);
    EXPECT_NEAR(all.picture[0].b, 1, 0.4);
}

TEST(SumInflation, IsBelowOneWhereErrorsCancel) {
    const SumInflations all = found(renders(8, opposed, 1), renders(8, independent, 2));
    EXPECT_LT(mean_of(all, &Inflation::a), 0.05);
    EXPECT_LT(all.picture[0].a, 0.05);
}

TEST(SumInflation, IsARegionsOwn) {
    const SumInflations all = found(renders(8, in_fours_at_the_left, 1), renders(8, independent, 2));
    EXPECT_NEAR(mean_of(all, &Inflation::a, 0, 2), 4, 1);
    EXPECT_NEAR(mean_of(all, &Inflation::a, 6, 2), 1, 0.25);
}

/// A tile's is of 25 tiles, or of as many as the picture has there, of R − 1 degrees each.
TEST(SumInflation, KnowsItsDegrees) {
    const SumInflations all = found(renders(4, independent, 1), renders(2, independent, 2));
    EXPECT_EQ(all.tiles[3 * 8 + 3].degrees_a, 25 * 3);
    EXPECT_EQ(all.tiles[3 * 8 + 3].degrees_b, 25);
    EXPECT_EQ(all.tiles[0].degrees_a, 9 * 3);
}

/// Ratios of variances of sums to sums of variances have expectation 1, and the spread that their degrees say.
TEST(SumInflation, HasTheSpreadThatItsDegreesSay) {
    Moments picture;
    constexpr int runs = 100;
    double degrees = 0;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        const SumInflations all = found(renders(4, independent, 2 * seed), renders(4, independent, 2 * seed + 1));
        picture.add(all.picture[0].a);
        degrees += all.picture[0].degrees_a / runs;
    }
    EXPECT_NEAR(degrees, 48, 12);  // 16 blocks of 3
    EXPECT_NEAR(picture.mean(), 1, 5 * picture.standard_error());
    EXPECT_NEAR(picture.variance() * degrees / 2, 1, 0.7);
}

TEST(SumInflation, OfSinglePicturesIsWhatNeighboursCorrelate) {
    Picture a = renders(2, independent, 1), b = renders(2, independent, 2);
    a.residuals.clear();
    b.residuals.clear();
    const SumInflations all = inflations_of(a, b, grid_of(edge, edge, 8), {.reach = 1, .inflation = 3, .degrees = 100});
    EXPECT_FALSE(all.of_spread);
    EXPECT_EQ(all.picture[0].a, 3);
    EXPECT_EQ(all.picture[0].b, 3);
    EXPECT_EQ(all.degrees, 100);
}

}  // namespace
}  // namespace plumb
