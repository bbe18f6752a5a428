#include "integrators/drivers/splatting.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

constexpr FilmRegion crop{2, 3, 4, 2};

double sum_over(const Filter& filter, const FilmRegion& region, const Point<2>& film) {
    std::vector<ReachedPixel> pixels;
    find_reached(filter, region, film, pixels);
    double sum = 0;
    for (const ReachedPixel& pixel : pixels) sum += pixel.density;
    return sum;
}

TEST(Splatting, ABoxReachesThePixelOfThePointAlone) {
    std::vector<ReachedPixel> pixels{{9, 9, 9}};
    find_reached(BoxFilter(), crop, {3.25, 4.75}, pixels);
    ASSERT_EQ(pixels.size(), 1u);
    EXPECT_EQ(pixels[0].x, 3);
    EXPECT_EQ(pixels[0].y, 4);
    EXPECT_EQ(pixels[0].density, 1);
    find_reached(BoxFilter(), crop, {1.5, 4.5}, pixels);  // left of the crop
    EXPECT_TRUE(pixels.empty());
}

// Tents of radius 1 at the centres of all pixels sum to 1 everywhere.
TEST(Splatting, TentsAreAPartitionOfUnity) {
    const FilmRegion wide{-5, -5, 20, 20};
    for (const Point<2>& film : {Point<2>{3.5, 4.5}, {3.1, 4.9}, {0, 0}, {2.75, 3.125}})
        EXPECT_NEAR(sum_over(TentFilter(1), wide, film), 1, 1e-15);
}

TEST(Splatting, APixelOutsideOfTheCropTakesNothing) {
    std::vector<ReachedPixel> pixels;
    find_reached(TentFilter(1), crop, {2, 3}, pixels);  // the corner of four pixels, of which one is in the crop
    ASSERT_EQ(pixels.size(), 1u);
    EXPECT_EQ(pixels[0].density, 0.25);
}

PathRecord two_splats() {
    PathRecord record;
    record.splats.push_back({{3.5, 3.5}, Spectrum::grey(5), 2});
    record.splats.push_back({{3.5, 3.5}, Spectrum::grey(16), 2, true});
    return record;
}

TEST(Splatting, SharesSplatsAnywhereAmongThePathsOfTheCrop) {
    std::vector<SplatOnPixel> splats;
    spread(two_splats(), BoxFilter(), crop, splats);
    ASSERT_EQ(splats.size(), 1u);
    EXPECT_EQ(splats[0].x, 3);
    EXPECT_EQ(splats[0].y, 3);
    EXPECT_EQ(splats[0].value[0], 16.0 / 8);
}

TEST(Splatting, ARegionTakesItsOwnSplatsAndItsShareOfTheOthers) {
    EXPECT_EQ(region_mean(two_splats(), crop, BoxFilter())[0], 5 + 16.0 / 8);
    EXPECT_EQ(region_mean(two_splats(), {5, 3, 1, 1}, BoxFilter())[0], 5);
}

}  // namespace
}  // namespace plumb
