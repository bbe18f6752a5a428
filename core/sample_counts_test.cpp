#include "core/sample_counts.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

TEST(ParseSampleCounts, AcceptsRangesAndLists) {
    EXPECT_EQ(parse_sample_counts("16..100"), (std::vector<std::uint64_t>{16, 32, 64}));
    EXPECT_EQ(parse_sample_counts("100,10,10"), (std::vector<std::uint64_t>{10, 100}));
    EXPECT_THROW(parse_sample_counts("0"), Error);
    EXPECT_THROW(parse_sample_counts("1,,2"), Error);
    EXPECT_THROW(parse_sample_counts("many"), Error);
}

}  // namespace
}  // namespace plumb
