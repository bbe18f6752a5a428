#include "core/shard.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

TEST(ParseShard, AcceptsAPartOfAWhole) {
    EXPECT_EQ(parse_shard("2/3").index, 2);
    EXPECT_EQ(parse_shard("2/3").count, 3);
    for (const char* wrong : {"3/2", "0/2", "1/0", "1", "/2", "1/", "1/2/3", "-1/2", "1/10001", ""})
        EXPECT_THROW(parse_shard(wrong), Error) << wrong;
}

}  // namespace
}  // namespace plumb
