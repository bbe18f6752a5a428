#include "integrators/drivers/schedule.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <future>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "core/parallel.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using namespace std::chrono_literals;

// What was finished, in its order.
struct Passes {
    std::vector<std::uint32_t> begun, finished;
    std::vector<std::atomic<int>> made;

    explicit Passes(std::uint32_t count) : made(count) {}
    PassWork work(std::size_t pieces, std::size_t in_flight) {
        return {.passes = static_cast<std::uint32_t>(made.size()),
                .pieces = pieces,
                .in_flight = in_flight,
                .begin = [this](std::uint32_t pass) { begun.push_back(pass); },
                .make = [this](std::uint32_t pass, std::size_t) { ++made[pass]; },
                .finish =
                    [this, pieces](std::uint32_t pass) {
                        EXPECT_EQ(made[pass], static_cast<int>(pieces));
                        finished.push_back(pass);
                        return true;
                    }};
    }
};

TEST(Schedule, FinishesEveryPassInOrder) {
    for (const int threads : {1, 2})
        with_threads(threads, [] {
            Passes passes(50);
            work_off(passes.work(7, 3));
            std::vector<std::uint32_t> all(50);
            std::iota(all.begin(), all.end(), 0u);
            EXPECT_EQ(passes.begun, all);
            EXPECT_EQ(passes.finished, all);
        });
}

TEST(Schedule, EndsWithThePassThatIsToBeTheLast) {
    for (const int threads : {1, 2})
        with_threads(threads, [] {
            Passes passes(50);
            PassWork work = passes.work(3, 8);
            work.finish = [&](std::uint32_t pass) {
                passes.finished.push_back(pass);
                return pass < 3;
            };
            work_off(work);
            EXPECT_THAT(passes.finished, ElementsAre(0, 1, 2, 3));
        });
}

// While one thread is held up in the first pass' only piece, the other goes through the four passes after it; a barrier
// would keep it from that.
TEST(Schedule, NoThreadWaitsForTheLastPieceOfAPass) {
    with_threads(2, [] {
        Passes passes(5);
        PassWork work = passes.work(1, 5);
        std::promise<void> others_made;
        std::atomic<int> made_elsewhere = 0;
        bool met = false;
        work.make = [&](std::uint32_t pass, std::size_t) {
            ++passes.made[pass];
            if (pass == 0)
                met = others_made.get_future().wait_for(20s) == std::future_status::ready;
            else if (++made_elsewhere == 4)
                others_made.set_value();
        };
        EXPECT_EQ(work_off(work).count, 0u);
        EXPECT_TRUE(met);
        EXPECT_THAT(passes.finished, ElementsAre(0, 1, 2, 3, 4));
    });
}

TEST(Schedule, WaitsWhereNoMorePassesMayBeBegun) {
    with_threads(2, [] {
        Passes passes(2);
        PassWork work = passes.work(1, 1);
        std::atomic<bool> in_second = false;
        work.make = [&](std::uint32_t pass, std::size_t) {
            ++passes.made[pass];
            in_second = in_second || pass == 1;
            if (pass > 0) return;
            std::this_thread::sleep_for(50ms);
            EXPECT_FALSE(in_second);
        };
        work_off(work);
        EXPECT_THAT(passes.finished, ElementsAre(0, 1));
    });
}

TEST(Schedule, PassesAnExceptionOn) {
    for (const char* where : {"begin", "make", "finish"})
        with_threads(2, [where] {
            Passes passes(20);
            PassWork work = passes.work(2, 2);
            const auto fail = [&](const char* here, std::uint32_t pass) {
                if (where == std::string(here) && pass == 5) throw std::runtime_error(where);
            };
            work.begin = [&](std::uint32_t pass) { fail("begin", pass); };
            work.make = [&](std::uint32_t pass, std::size_t) { fail("make", pass); };
            work.finish = [&](std::uint32_t pass) {
                fail("finish", pass);
                return true;
            };
            EXPECT_THROW(work_off(work), std::runtime_error) << where;
        });
}

TEST(Schedule, HasNothingToDoWithoutPasses) {
    Passes passes(0);
    work_off(passes.work(3, 2));
    EXPECT_THAT(passes.finished, IsEmpty());
}

TEST(Schedule, KeepsEnoughPassesInFlightInBoundedMemory) {
    EXPECT_EQ(passes_in_flight(1, 64, 40'000), 257u);        // a tile a pass: four for each thread
    EXPECT_EQ(passes_in_flight(64, 64, 2'600'000), 5u);      // 128 × 128 pixels
    EXPECT_EQ(passes_in_flight(8100, 64, 330'000'000), 2u);  // 1920 × 1080
    EXPECT_EQ(passes_in_flight(1, 64, std::size_t{1} << 30), 2u);
}

}  // namespace
}  // namespace plumb
