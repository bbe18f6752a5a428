#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/command_test.h"
#include "core/images/image.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class CheckCommand : public CommandTest {
protected:
    /// A picture of the file's values times a factor; its variance layers stay as they are.
    void brighten(const std::string& from, float factor, const std::string& to) const {
        Image image = read_image(folder / from);
        for (std::size_t i = 0; i < image.values.size(); i += image.channels.size())
            for (std::size_t c = 0; c < 3; ++c) image.values[i + c] *= factor;
        write_image(folder / to, image);
    }
};

TEST_F(CheckCommand, HonestRendersHoldAndBrighterOnesAreRefuted) {
    struct Case {
        const char *scene, *how, *delta;
        float brighter;
    };
    for (const auto& [scene, how, delta, brighter] :
         {Case{"furnace_box", "path --max-depth 1 --spp 16", "1%", 1.02f},
          Case{"furnace_box", "path --max-depth 2 --sampler sobol --spp 256", "1%", 1.04f},
          Case{"point_light", "path --spp 16", "1%", 1.02f}, Case{"white_sphere", "direct --spp 1024", "4%", 1.12f}}) {
        const std::string name = scene, call = "render " + name + " --integrator " + how + " --seed 3 -o a.exr";
        ASSERT_EQ(plumb(call).exit_code, 0) << call;
        const std::string check = " --expect " + name + " --delta " + delta + " --json c.json";
        const Said holds = plumb("check a.exr" + check);
        EXPECT_EQ(holds.exit_code, 0) << call << "\n" << holds.out << holds.error;
        EXPECT_EQ(nlohmann::json::parse(read("c.json"))["outcome"], "holds");
        brighten("a.exr", brighter, "b.exr");
        const Said refuted = plumb("check b.exr" + check);
        EXPECT_EQ(refuted.exit_code, 1) << call << "\n" << refuted.out << refuted.error;
        EXPECT_EQ(nlohmann::json::parse(read("c.json"))["outcome"], "refuted");
    }
}

TEST_F(CheckCommand, IsUndecidedWhereNoiseIsLargerThanDelta) {
    ASSERT_EQ(plumb("render quad_light --integrator direct-bsdf --spp 16 --seed 3 -o a.exr").exit_code, 0);
    const Said said = plumb("check a.exr --expect quad_light --delta 1%");
    EXPECT_EQ(said.exit_code, 3) << said.out;
    EXPECT_THAT(said.out, AllOf(HasSubstr("heavy tails"), HasSubstr("undecided: 21 of 21 values are not decided")));
}

/// A furnace is 2 everywhere, all light counted: with few samples no pixel tells that alone, all of them do.
TEST_F(CheckCommand, HoldsAFilmWhosePixelsAreTooNoisy) {
    std::string radiances = R"({"over": "film", "edges": null, "value": [2, 2, 2], "error": 0, "derivation": "so"},
        {"over": "rectangle", "rectangle": [8, 8, 40.5, 40], "edges": null, "value": [2, 2, 2], "error": 0, "derivation": ""})";
    const auto expected = [](const std::string& list) {
        return R"({"question": "?", "film": [64, 64], "radiances": [)" + list + "]}";
    };
    write("film.json", expected(radiances));
    for (int i = 0; i < 100; ++i)
        radiances += fmt::format(R"(,{{"film": [{}, {}], "over": "pixel", "edges": null, "value": [2, 2, 2],
                                       "error": 0, "derivation": ""}})",
                                 6 * (i % 10), 6 * (i / 10));
    write("all.json", expected(radiances));
    ASSERT_EQ(plumb("render furnace_box --integrator path --spp 256 --rr-depth 2 --seed 5 -o a.exr").exit_code, 0);
    const Said film = plumb("check a.exr --expect film.json --delta 0.5%");
    EXPECT_EQ(film.exit_code, 0) << film.out << film.error;
    EXPECT_THAT(film.out, AllOf(HasSubstr("film"), HasSubstr("40.5 x 40 at (8, 8)")));
    const Said all = plumb("check a.exr --expect all.json --delta 2% --json c.json");
    EXPECT_EQ(all.exit_code, 3) << all.out << all.error;  // pixels with heavy tails: what all say together is told
    EXPECT_THAT(all.out, AllOf(HasSubstr("all 102 together"), HasSubstr("; together their mean of R is ")));
    EXPECT_EQ(nlohmann::json::parse(read("c.json"))["together"].size(), 3U);
    brighten("a.exr", 1.03f, "b.exr");
    EXPECT_EQ(plumb("check b.exr --expect film.json --delta 0.5%").exit_code, 1);
    EXPECT_EQ(plumb("check b.exr --expect all.json --delta 2%").exit_code, 1);
}

class ForeignImage : public CheckCommand {
protected:
    void SetUp() override {
        write("e.json", R"({"question": "?", "film": [8, 8], "radiances": [
            {"film": [4, 4], "over": "point", "edges": 2, "value": [1, 2, 4], "error": 0, "derivation": "so"}]})");
        for (int i = 0; i < 4; ++i) render("r" + std::to_string(i) + ".exr", 1 + 0.001f * static_cast<float>(i));
    }
    void render(const std::string& name, float level, int size = 8) const {
        Image image{size, size, {"R", "G", "B"}, {}};
        for (int i = 0; i < size * size; ++i)
            for (const float c : {1.f, 2.f, 4.f}) image.values.push_back(c * level);
        write_image(folder / name, image);
    }
};

TEST_F(ForeignImage, TellsItsErrorBySeveralRendersOrNotAtAll) {
    const Said alone = plumb("check r3.exr --expect e.json --edges 2");
    EXPECT_EQ(alone.exit_code, 0) << alone.out << alone.error;
    EXPECT_THAT(alone.out, HasSubstr("noise counts as deviation"));
    EXPECT_EQ(plumb("check r3.exr --expect e.json --edges 2 --delta 0.1%").exit_code, 1);
    EXPECT_EQ(plumb("check r0.exr r1.exr r2.exr r3.exr --expect e.json --edges 2").exit_code, 0);
    // Their mean is 1.0015 with a standard error of 0.0006.
    EXPECT_EQ(plumb("check r0.exr r1.exr r2.exr r3.exr --expect e.json --edges 2 --delta 0.1%").exit_code, 3);
}

TEST_F(ForeignImage, IsToldWhatIsWrong) {
    render("small.exr", 1, 4);
    write_image(folder / "grey.exr", {8, 8, {"Y"}, std::vector<float>(64, 1.f)});
    EXPECT_THAT(complaint("check r0.exr --expect e.json"),
                StartsWith("plumb: r0.exr: does not say how long its paths may be; give --edges"));
    EXPECT_THAT(complaint("check r0.exr --expect e.json --edges 3"), HasSubstr("up to 3 edges; known are 2"));
    EXPECT_THAT(complaint("check r0.exr --expect e.json --edges all"), HasSubstr("paths of any length"));
    EXPECT_THAT(complaint("check r0.exr --expect e.json --edges none"), HasSubstr("'none'"));
    EXPECT_THAT(complaint("check small.exr --expect e.json --edges 2"),
                HasSubstr("small.exr: is 4x4 pixels, the film of e.json 8x8"));
    EXPECT_THAT(complaint("check grey.exr --expect e.json --edges 2"), HasSubstr("grey.exr: has channels Y"));
    EXPECT_THAT(complaint("check r0.exr --expect quad_ligth --edges 2"), HasSubstr("did you mean 'quad_light'"));
    EXPECT_THAT(complaint("check r0.exr --expect none.json --edges 2"), HasSubstr("none.json"));
    EXPECT_THAT(complaint("check none.exr --expect e.json --edges 2"), HasSubstr("none.exr"));
    EXPECT_THAT(complaint("check r0.exr"), HasSubstr("--expect"));
    ASSERT_EQ(plumb("render quad_light --integrator aov --spp 2 -o aov.exr").exit_code, 0);
    EXPECT_THAT(complaint("check aov.exr --expect quad_light"), HasSubstr("aov.exr: an image of `aov`"));
}

}  // namespace
}  // namespace plumb::cli
