#include "estimators/points/point_set_samples.h"

#include <gtest/gtest.h>

#include <set>

#include "estimators/points/sobol.h"
#include "estimators/points/stratified.h"

namespace plumb {
namespace {

const Slot film{0, Use::film}, light{3, Use::light_point};

TEST(PointSetSamples, SpreadsEachSlotOverAPass) {
    PointSetSamples samples(stratified_2d, 16);
    std::set<int> film_cells, light_cells;
    int same = 0;
    for (std::uint32_t i = 32; i < 48; ++i) {  // the third pass
        samples.start({7, 5, i});
        const auto cell = [](const std::array<double, 2>& u) { return int(u[0] * 4) * 4 + int(u[1] * 4); };
        const int a = cell(samples.at(film).u), b = cell(samples.at(light).u);
        film_cells.insert(a);
        light_cells.insert(b);
        same += a == b;
    }
    EXPECT_EQ(film_cells.size(), 16u);
    EXPECT_EQ(light_cells.size(), 16u);
    EXPECT_LT(same, 8);  // orders of their own
}

TEST(PointSetSamples, ReplaysAPathFromItsKey) {
    PointSetSamples whole(owen_sobol_2d, 8), one(owen_sobol_2d, 8);
    std::array<double, 2> u{};
    for (std::uint32_t i = 0; i < 16; ++i) {
        whole.start({1, 2, i});
        whole.at(film);
        if (i == 13) u = whole.at(light).u;
    }
    one.start({1, 2, 13});
    EXPECT_EQ(one.at(light).u, u);  // without the slots and samples before
    one.start({1, 3, 13});
    EXPECT_NE(one.at(light).u, u);
}

TEST(PointSetSamples, KeepsEverySlotApart) {
    PointSetSamples samples(owen_sobol_2d, 4);
    samples.start({1, 2, 3});
    std::set<std::array<double, 2>> numbers;
    std::size_t slots = 0;
    for (const int first : {0, 0x8000})
        for (int vertex = first; vertex < first + 3; ++vertex)
            for (std::size_t use = 0; use < use_count; ++use)
                for (std::uint8_t sample = 0; sample < 3; ++sample, ++slots)
                    numbers.insert(samples.at({static_cast<std::uint16_t>(vertex), static_cast<Use>(use), sample}).u);
    EXPECT_EQ(numbers.size(), slots);
}

}  // namespace
}  // namespace plumb
