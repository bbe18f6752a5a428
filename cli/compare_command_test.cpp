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
using testing::Not;

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

class CompareWithoutErrors : public CompareCommand {
protected:
    /// The colours of a file of render(), and nothing else, changed.
    template <class Change>
    void colours_of(const std::string& from, const std::string& to, Change change) const {
        const Image all = read_image(folder / from);
        Image image{all.width, all.height, {"R", "G", "B"}, {}};
        for (int i = 0; i < 32 * 32; ++i)
            for (const std::size_t c : {2, 1, 0}) image.values.push_back(change(all.at(i % 32, i / 32, c)));
        write_image(folder / to, image);
    }
    void SetUp() override {
        render("a.exr", 0.5f);
        render("b.exr", 0.5f);
        colours_of("a.exr", "plain_a.exr", [](float v) { return v; });
        colours_of("b.exr", "plain_b.exr", [](float v) { return v; });
    }
};

TEST_F(CompareWithoutErrors, TellsErrorsAndWhyThereIsNoVerdict) {
    const Said said = plumb("compare plain_a.exr plain_b.exr --json c.json --report c.html");
    EXPECT_EQ(said.exit_code, 3) << said.error;
    EXPECT_THAT(said.out, AllOf(HasSubstr("undecided: no verdict, because the error of a and b is unknown"),
                                HasSubstr("--a, --b"), HasSubstr("RMSE 0.07"), HasSubstr("relMSE"), HasSubstr("MRSE"),
                                HasSubstr("MAPE"), HasSubstr(" FLIP 0."), HasSubstr("HDR-FLIP 0.")));
    const auto json = nlohmann::json::parse(read("c.json"));
    EXPECT_EQ(json["outcome"], "undecided");
    EXPECT_EQ(json["error_known"], false);
    EXPECT_EQ(json["tiles"].size(), 0U);
    ASSERT_EQ(json["errors"].size(), 6U);
    EXPECT_EQ(json["errors"][4]["name"], "FLIP");
    EXPECT_TRUE(json["errors"][0]["low"].is_null());
    EXPECT_NEAR(json["channels"][0]["mean"]["a"].get<double>(), 0.5, 0.02);
    EXPECT_THAT(read("c.html"), HasSubstr("comparison undecided"));
}

TEST_F(CompareWithoutErrors, NamesTheSideThatLacksIt) {
    EXPECT_THAT(plumb("compare a.exr plain_b.exr --report ''").out,
                AllOf(HasSubstr("the error of b is unknown"), HasSubstr("--exact-b")));
    const Said a = plumb("compare plain_a.exr b.exr --report ''");
    EXPECT_THAT(a.out, AllOf(HasSubstr("the error of a is unknown"), Not(HasSubstr("--exact-b"))));
    EXPECT_EQ(plumb("compare a.exr plain_b.exr --exact-b --report ''").exit_code, 1);  // its noise is a difference
}

TEST_F(CompareWithoutErrors, FindsNoneBetweenEqualImages) {
    const Said said = plumb("compare plain_a.exr plain_a.exr --report ''");
    EXPECT_EQ(said.exit_code, 3);
    EXPECT_THAT(said.out, AllOf(HasSubstr("undecided: b is a copy of a, the same samples"), HasSubstr("RMSE 0 "),
                                HasSubstr(" FLIP 0 "), HasSubstr("HDR-FLIP 0 ")));
}

TEST_F(CompareWithoutErrors, TakesIntegersForWhatTheyShow) {
    colours_of("a.exr", "a.png",
               [](float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; });
    const Said said = plumb("compare plain_a.exr a.png --report '' --json c.json");
    EXPECT_EQ(said.exit_code, 3) << said.error;
    EXPECT_THAT(said.out, HasSubstr("b is a copy of a, rounded to"));
    EXPECT_LT(nlohmann::json::parse(read("c.json"))["errors"][0]["value"].get<double>(), 0.003);
}

TEST_F(CompareWithoutErrors, NamesWhatIsACopyFirst) {
    const auto says = [&](auto change, const char* what, bool can_be_undone) {
        colours_of("a.exr", "copy.exr", change);
        EXPECT_THAT(plumb("compare plain_a.exr copy.exr --report ''").out,
                    HasSubstr(std::string("undecided: b is a copy of a, ") + what));
        EXPECT_THAT(plumb("compare copy.exr plain_a.exr --report ''").out,
                    HasSubstr(can_be_undone ? "undecided: b is a copy of a, " : "undecided: a is a copy of b, "));
        EXPECT_THAT(plumb("compare a.exr copy.exr --report ''").out,
                    HasSubstr(std::string("undecided: b is a copy of a, ") + what));
    };
    says([](float v) { return std::min(v, 0.5f); }, "cut off at 0.5,", false);
    says([](float v) { return 1.5f * v; }, "multiplied by 1.5,", true);
    says([](float v) { return std::round(255 * v) / 255; }, "rounded to", false);
    says([](float v) { return std::min(1.f, 2 * v * v); }, "", true);
}

TEST_F(CompareCommand, SaysWhatIsWrong) {
    render("a.exr", 1, {{"plumb:seed", "7"}});
    render("b.exr", 1, {{"plumb:seed", "7"}});
    write_image(folder / "plain.exr", {32, 32, {"R", "G", "B"}, std::vector<float>(3 * 32 * 32, 1.f)});
    write_image(folder / "small.exr", {16, 16, {"R", "G", "B"}, std::vector<float>(3 * 16 * 16, 1.f)});
    EXPECT_THAT(complaint("compare a.exr b.exr"), HasSubstr("both have seed 7"));
    EXPECT_THAT(complaint("compare a.exr"), HasSubstr("there is no image b"));
    EXPECT_THAT(complaint("compare small.exr plain.exr"), HasSubstr("image a is 16x16 pixels, image b 32x32"));
    EXPECT_THAT(complaint("compare a.exr small.exr --exact-b"), HasSubstr("image a is 32x32 pixels, image b 16x16"));
    EXPECT_THAT(complaint("compare a.exr nothing.exr"), HasSubstr("nothing.exr"));
    EXPECT_THAT(complaint("compare a.exr b.exr --delta lots"), HasSubstr("'lots'"));
}

}  // namespace
}  // namespace plumb::cli
