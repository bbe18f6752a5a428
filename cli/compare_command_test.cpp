#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command_test.h"
#include "core/images/image.h"
#include "core/random.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CompareCommand : public CommandTest {
protected:
    /// An image of one colour with layers of a variance that is small; of no random numbers.
    void render(const std::string& name, float value, std::map<std::string, std::string> metadata = {}) const {
        Image image{32, 32, {"B", "G", "R", "variance.B", "variance.G", "variance.R"}, {}};
        metadata["plumb:replicates"] = "16";
        image.metadata = metadata;
        RandomStream random(stream_id(name));
        for (int i = 0; i < 32 * 32; ++i) {
            const auto noise = static_cast<float>(1 + 0.1 * std::sqrt(12) * (random.uniform() - 0.5));
            for (int c = 0; c < 3; ++c) image.values.push_back(value * noise);
            for (int c = 0; c < 3; ++c) image.values.push_back(0.01f * value * value);
        }
        write_image(folder / name, image);
    }
};

TEST_F(CompareCommand, EndsAsTheVerdictSays) {
    render("a.exr", 1);
    render("b.exr", 1);
    render("c.exr", 1.2f);
    const Said holds = plumb("compare a.exr b.exr --delta 5% --tile-delta 20% --json c.json --report c.html");
    EXPECT_EQ(holds.exit_code, 0) << holds.out << holds.error;
    EXPECT_THAT(holds.out, AllOf(HasSubstr("holds: every channel's mean is equal within 5 %"), HasSubstr("RMSE")));
    EXPECT_EQ(nlohmann::json::parse(read("c.json"))["outcome"], "holds");
    EXPECT_THAT(read("c.html"), HasSubstr("<title>Plumb: comparison holds</title>"));
    const Said refuted = plumb("compare a.exr c.exr --report ''");
    EXPECT_EQ(refuted.exit_code, 1);
    EXPECT_THAT(refuted.out, HasSubstr("Tiles that differ, worst first"));
    EXPECT_EQ(plumb("compare a.exr b.exr --delta 0.01% --report ''").exit_code, 3);
}

TEST_F(CompareCommand, TakesSeveralRendersOfEach) {
    for (const char* name : {"a.exr", "b.exr", "c.exr", "d.exr"}) render(name, 1);
    EXPECT_EQ(plumb("compare --a a.exr b.exr --b c.exr d.exr --delta 5% --tile-delta 20% --report ''").exit_code, 0);
}

TEST_F(CompareCommand, SaysWhatIsWrong) {
    render("a.exr", 1, {{"plumb:seed", "7"}});
    render("b.exr", 1, {{"plumb:seed", "7"}});
    write_image(folder / "plain.exr", {32, 32, {"R", "G", "B"}, std::vector<float>(3 * 32 * 32, 1.f)});
    write_image(folder / "small.exr", {16, 16, {"R", "G", "B"}, std::vector<float>(3 * 16 * 16, 1.f)});
    EXPECT_THAT(complaint("compare a.exr b.exr"), HasSubstr("both have seed 7"));
    EXPECT_THAT(complaint("compare a.exr"), HasSubstr("there is no image b"));
    EXPECT_THAT(complaint("compare a.exr plain.exr"), HasSubstr("plain.exr: one image without layers variance.R"));
    EXPECT_THAT(complaint("compare a.exr small.exr --exact-b"), HasSubstr("image a is 32x32 pixels, image b 16x16"));
    EXPECT_THAT(complaint("compare a.exr nothing.exr"), HasSubstr("nothing.exr"));
    EXPECT_THAT(complaint("compare a.exr b.exr --delta lots"), HasSubstr("'lots'"));
}

}  // namespace
}  // namespace plumb::cli
