#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace plumb {
namespace {

TEST(ForBatches, RunsEveryBatchOnce) {
    std::vector<int> runs(1000);
    for_batches(runs.size(), [&](std::size_t i) { ++runs[i]; });
    EXPECT_EQ(runs, std::vector<int>(1000, 1));
}

TEST(ForBatches, MayBeNested) {
    std::atomic<int> total = 0;
    with_threads(2, [&] { for_batches(8, [&](std::size_t) { for_batches(8, [&](std::size_t) { ++total; }); }); });
    EXPECT_EQ(total, 64);
}

TEST(ForBatches, PassesAnExceptionOn) {
    const auto fail = [](std::size_t i) {
        if (i == 3) throw std::runtime_error("batch 3");
    };
    EXPECT_THROW(for_batches(10, fail), std::runtime_error);
}

}  // namespace
}  // namespace plumb
