// The long verbs that keep nothing of a part of their work say so when they are stopped.

#include <gmock/gmock.h>

#include <algorithm>

#include "cli/test_program.h"

namespace plumb::cli {
namespace {

using testing::HasSubstr;

struct LongWork {
    std::vector<std::string> arguments;
    std::string said, output;
};

class Stopped : public testing::TestWithParam<LongWork> {};

TEST_P(Stopped, SaysWhatIsSaved) {
    const auto& [arguments, said, output] = GetParam();
    for (const int signal : {SIGINT, SIGTERM}) {
        const TestFolder folder;
        Program program(folder.path(), arguments);
        program.wait_until_it_catches(signal);
        program.send(signal);
        EXPECT_EQ(program.wait(), 128 + signal);
        const std::string name = signal == SIGINT ? "SIGINT" : "SIGTERM";
        EXPECT_THAT(program.errors(), HasSubstr("plumb: stopped by " + name + ": " + said));
        EXPECT_EQ(std::ranges::count(program.errors(), '\n'), 1);
        EXPECT_FALSE(std::filesystem::exists(folder / output)) << "no partial output";
    }
}

std::vector<LongWork> long_works() {
    return {
        {{"render", "furnace_box", "--spp", "1000000", "-o", "a.exr"}, "nothing is saved; a.exr is as it was", "a.exr"},
        {{"reference", "furnace_box", "--error", "0.001%"}, "nothing is saved; out/references", "out/references"},
        {{"converge", "independent", "--on", "exp", "--replicates", "10000000", "--json", "a.json"},
         "nothing is saved",
         "a.json"},
        {{"integrate", "sin(x*y)", "--n", "4000000000", "--json", "a.json"}, "nothing is saved", "a.json"},
        {{"study", "boundary", "--replicates", "10000000"},
         "nothing is saved; out/study-boundary is as it was",
         "out/study-boundary"}};
}

INSTANTIATE_TEST_SUITE_P(Verbs, Stopped, testing::ValuesIn(long_works()),
                         [](const auto& work) { return work.param.arguments.front(); });

}  // namespace
}  // namespace plumb::cli
