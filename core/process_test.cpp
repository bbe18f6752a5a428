#include "core/process.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <csignal>
#include <thread>

#include "core/error.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using namespace std::chrono_literals;

std::vector<std::string> lines_of(const std::string& command, std::chrono::duration<double> limit = 20s) {
    std::vector<std::string> lines;
    EXPECT_FALSE(read_lines(command, limit, [&](std::string_view line) {
        lines.emplace_back(line);
        return true;
    }));
    return lines;
}

std::string complaint(const std::string& command, std::chrono::duration<double> limit = 20s) {
    try {
        read_lines(command, limit, [](std::string_view) { return true; });
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(ReadLines, HandsOverEveryLine) {
    EXPECT_THAT(lines_of("printf 'a\\n\\nb'"), ElementsAre("a", "", "b"));
    EXPECT_EQ(lines_of("seq 100000").size(), 100000u);
    EXPECT_TRUE(lines_of("true").empty());
}

TEST(ReadLines, StopsACommandThatWouldGoOnForEver) {
    int taken = 0;
    EXPECT_TRUE(read_lines("yes | cat", 20s, [&](std::string_view) { return ++taken < 10; }));
    EXPECT_EQ(taken, 10);
}

TEST(ReadLines, NamesACommandThatFails) {
    EXPECT_EQ(complaint("echo out; echo first >&2; echo second >&2; exit 3"),
              "'echo out; echo first >&2; echo second >&2; exit 3' ended with exit code 3: second");
    EXPECT_THAT(complaint("./no-such-program 1"), HasSubstr("exit code 127"));
    EXPECT_THAT(complaint("kill -SEGV $$"), HasSubstr("signal 11"));
}

TEST(ReadLines, StopsWhatHangs) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(complaint("sleep 60 | cat", 0.2s), "'sleep 60 | cat' was not done after 0.2 s and was stopped");
    EXPECT_THAT(complaint("exec >&- 2>&-; sleep 60; true", 0.2s),
                HasSubstr("was stopped"));  // output closed, not ended
    EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
}

TEST(ReadLinesDeathTest, EndsTheCommandWhenThisProcessIsInterrupted) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans come to this process
    const auto interrupted = [] {
        read_lines("echo $$; sleep 60; true", 20s, [](std::string_view group) {
            fmt::print(stderr, "group {}.", group);
            std::raise(SIGTERM);
            return true;
        });
    };
    std::string printed;
    EXPECT_EXIT(interrupted(), testing::KilledBySignal(SIGTERM),
                testing::ResultOf(
                    [&](const std::string& text) {
                        printed = text;
                        return true;
                    },
                    testing::IsTrue()));
    const std::size_t begin = printed.find("group ") + 6;
    const pid_t group = std::stoi(printed.substr(begin));
    pid_t left = 0;  // -1: of the group nothing is left
    for (int tries = 0; tries < 500 && left >= 0; ++tries) {
        left = waitpid(-group, nullptr, WNOHANG);
        if (left == 0) std::this_thread::sleep_for(10ms);
    }
    EXPECT_EQ(left, -1) << "process group " << group << " still runs";
}

TEST(ReadLines, RefusesALineWithoutEnd) {
    EXPECT_THAT(complaint("yes | tr -d '\\n'"), HasSubstr("without an end of line"));
}

TEST(ReadLines, GivesTheCommandNoInput) {
    EXPECT_TRUE(lines_of("cat").empty());
}

}  // namespace
}  // namespace plumb
