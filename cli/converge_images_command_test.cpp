#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command_test.h"
#include "core/images/image.h"
#include "core/random.h"

namespace plumb::cli {
namespace {

using testing::HasSubstr;

class ConvergeImages : public CommandTest {
protected:
    /// A grey picture whose pixels have uniform noise of variance 1/spp about 2; or none.
    void render(const std::string& name, double spp, int size = 32) const {
        Image image{size, size, {"R", "G", "B"}, {}};
        RandomStream random(stream_id(name));
        for (int i = 0; i < size * size; ++i) {
            const double noise = spp > 0 ? std::sqrt(12 / spp) * (random.uniform() - 0.5) : 0;
            for (int c = 0; c < 3; ++c) image.values.push_back(static_cast<float>(2 + noise));
        }
        write_image(folder / name, image);
    }
    void SetUp() override {
        for (const int spp : {4, 16, 64})
            for (const char* seed : {"1", "2", "3"}) render("out_" + std::to_string(spp) + "_" + seed + ".exr", spp);
        render("ref.exr", 0);
        write("out_4_note.txt", "no image");
    }
};

TEST_F(ConvergeImages, HaveTheErrorAndTheSlopeThatTheyHave) {
    const Said said =
        plumb("converge --images 'out_{spp}_{seed}.exr' --reference ref.exr --json c.json --report c.html");
    ASSERT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, HasSubstr("truth of out_{spp}_{seed}.exr: ref.exr, whose own variance is not known"));
    const auto series = nlohmann::json::parse(read("c.json"))["series"][0];
    EXPECT_EQ(series["replicates"], 3);
    for (const auto& point : series["points"]) {
        const double expected = 1 / point["n"].get<double>();
        EXPECT_LT(point["mse_low"], expected * 1.02);
        EXPECT_GT(point["mse_high"], expected * 0.98);
        EXPECT_NEAR(point["mse"], expected, 0.1 * expected);
        EXPECT_TRUE(point["seconds"].is_null());
    }
    EXPECT_NEAR(series["slope"]["value"], -1, 0.05);
    EXPECT_THAT(read("c.html"), HasSubstr("out_{spp}_{seed}.exr"));
}

TEST_F(ConvergeImages, OfSeveralPatternsShareOnePlot) {
    for (const int spp : {4, 16})
        for (const char* seed : {"1", "2"}) render("b_" + std::to_string(spp) + "_" + seed + ".exr", 4 * spp);
    const Said said = plumb(
        "converge --images 'out_{spp}_{seed}.exr' 'b_{spp}_{seed}.exr' --reference ref.exr --report c.html "
        "--csv c.csv --svg c.svg");
    ASSERT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, testing::AllOf(HasSubstr("b_{spp}_{seed}.exr\n"), HasSubstr("relMSE")));
    EXPECT_THAT(read("c.svg"), testing::AllOf(HasSubstr("<svg"), HasSubstr("Error of renders"),
                                              HasSubstr("samples per pixel"), HasSubstr("relative MSE"),
                                              HasSubstr("out_{spp}_{seed}.exr"), HasSubstr("b_{spp}_{seed}.exr")));
    EXPECT_THAT(read("c.csv"), testing::AllOf(testing::StartsWith("pattern,reference,spp,images,seconds,mse"),
                                              HasSubstr("\nb_{spp}_{seed}.exr,ref.exr,16,2,,")));
    EXPECT_THAT(read("c.html"),
                testing::AllOf(HasSubstr("<title>Plumb: Error of renders"), HasSubstr("\"renders\":true")));
    EXPECT_THAT(complaint("converge independent --on exp --csv c2.csv"), HasSubstr("--csv requires --images"));
}

TEST_F(ConvergeImages, TakeSecondsFromTheirNames) {
    for (const char* name : {"t_4_0.5.exr", "t_16_2.exr"}) render(name, std::string(name)[2] == '4' ? 4 : 16);
    ASSERT_EQ(plumb("render quad_light --spp 16 --seed 1 --crop 0,0,32,32 -o r.exr").exit_code, 0);
    const Said said = plumb("converge --images 't_{spp}_{seconds}.exr' --reference r.exr --report ''");
    ASSERT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, HasSubstr("1/(mse·seconds)"));
    EXPECT_THAT(said.out, HasSubstr("whose own variance is subtracted"));
}

TEST_F(ConvergeImages, AreToldWhatIsWrong) {
    const auto complains = [&](const std::string& pattern, const std::string& reference = "ref.exr") {
        return complaint("converge --images '" + pattern + "' --reference " + reference);
    };
    EXPECT_THAT(complains("out.exr"), HasSubstr("'out.exr' has no {spp}"));
    EXPECT_THAT(complains("out_{spp}_{size}.exr"), HasSubstr("has a {size}"));
    EXPECT_THAT(complains("render_{spp}.exr"), HasSubstr("render_{spp}.exr: no file matches"));
    EXPECT_THAT(complains("none/out_{spp}.exr"), HasSubstr("there is no folder none"));
    EXPECT_THAT(complains("out_{spp}_{seed}.txt"), HasSubstr("out_4_note.txt"));
    EXPECT_THAT(complains("out_{spp}_{seed}.exr", "out_4_1.exr"), HasSubstr("out_4_1.exr: the reference is among"));
    EXPECT_THAT(complains("out_{spp}_{seed}.exr", "none.exr"), HasSubstr("none.exr"));
    EXPECT_THAT(complains("out_{spp}_1.exr"), HasSubstr("out_4_1.exr: the only image of 4 samples"));
    EXPECT_THAT(complaint("converge --images 'out_{spp}_{seed}.exr'"), HasSubstr("--reference FILE"));
    EXPECT_THAT(complaint("converge path --images 'out_{spp}_{seed}.exr' --reference ref.exr"), HasSubstr("--images"));
    EXPECT_THAT(complains("out_{spp}_{seed}.exr", "auto"), HasSubstr("auto is for scenes"));
    for (const char* option : {"--cache c", "--n 4", "--replicates 4", "--seed 4"})
        EXPECT_THAT(complains("out_{spp}_{seed}.exr", std::string("ref.exr ") + option), HasSubstr("--images"));
    EXPECT_THAT(complaint("converge path"), HasSubstr("Give estimators and --on, or --images"));
    render("out_64_4.exr", 64, 16);
    EXPECT_THAT(complains("out_{spp}_{seed}.exr"), HasSubstr("out_64_4.exr: is 16x16 pixels, the reference 32x32"));
    write_image(folder / "a_4_1.exr", {32, 32, {"R", "G", "B"}, std::vector<float>(3072), {{"plumb:seed", "7"}}});
    write_image(folder / "a_4_2.exr", {32, 32, {"R", "G", "B"}, std::vector<float>(3072), {{"plumb:seed", "7"}}});
    EXPECT_THAT(complains("a_{spp}_{seed}.exr"), HasSubstr("both have seed 7"));
}

}  // namespace
}  // namespace plumb::cli
