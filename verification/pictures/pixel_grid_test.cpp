#include "verification/pictures/pixel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumb {
namespace {

TEST(PixelGrid, CoversEveryPixelOnceWithoutRests) {
    for (const auto& [width, height, tile] :
         {std::tuple{64, 64, 8}, {65, 30, 8}, {7, 100, 8}, {1, 1, 8}, {31, 17, 5}, {8, 8, 16}}) {
        const PixelGrid grid = grid_of(width, height, tile);
        ASSERT_EQ(grid.boxes.size(), static_cast<std::size_t>(grid.columns * grid.rows));
        std::vector<int> covered(static_cast<std::size_t>(width * height));
        for (const PixelBox& box : grid.boxes) {
            EXPECT_GE(box.width, std::min(tile, width));
            EXPECT_LT(box.width, 2 * tile);
            EXPECT_GE(box.height, std::min(tile, height));
            EXPECT_LT(box.height, 2 * tile);
            for_pixels(box, [&](int x, int y) { ++covered[static_cast<std::size_t>(y * width + x)]; });
        }
        EXPECT_TRUE(std::ranges::all_of(covered, [](int times) { return times == 1; })) << width << " x " << height;
    }
}

TEST(PixelGrid, IsInRows) {
    const PixelGrid grid = grid_of(24, 16, 8);
    EXPECT_EQ(grid.columns, 3);
    EXPECT_EQ(grid.rows, 2);
    const PixelBox& box = grid.boxes[grid.index(2, 1)];
    EXPECT_EQ(box.x, 16);
    EXPECT_EQ(box.y, 8);
}

TEST(PixelGrid, VisitsWhatIsAboutATile) {
    const PixelGrid grid = grid_of(40, 40, 8);
    const auto count = [&](int column, int row, int reach) {
        std::vector<std::size_t> seen;
        for_tiles_about(grid, column, row, reach, [&](std::size_t tile) { seen.push_back(tile); });
        EXPECT_TRUE(std::ranges::is_sorted(seen));
        EXPECT_TRUE(std::ranges::count(seen, grid.index(column, row)) == 1);
        return seen.size();
    };
    EXPECT_EQ(count(2, 2, 0), 1U);
    EXPECT_EQ(count(2, 2, 1), 9U);
    EXPECT_EQ(count(2, 2, 2), 25U);
    EXPECT_EQ(count(0, 0, 1), 4U);
    EXPECT_EQ(count(0, 2, 2), 15U);
}

}  // namespace
}  // namespace plumb
