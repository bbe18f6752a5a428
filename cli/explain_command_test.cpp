#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cli/command_test.h"
#include "core/images/image.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

class ExplainCommand : public CommandTest {
protected:
    /// The JSON of the sample, as `plumb explain` writes it.
    [[nodiscard]] Json told(const std::string& arguments) const {
        const Said said = plumb("explain " + arguments + " --json told.json");
        EXPECT_EQ(said.exit_code, 0) << said.error;
        return Json::parse(read("told.json"));
    }
    [[nodiscard]] static double red(const Image& image, int x, int y) {
        const auto found = std::ranges::find(image.channels, "R");
        return image.at(x, y, static_cast<std::size_t>(found - image.channels.begin()));
    }
};

TEST_F(ExplainCommand, TellsTheValueThatThePictureHas) {
    for (const std::string integrator : {"path", "bdpt", "direct", "light"}) {
        const std::string of = " --integrator " + integrator + " --seed 7 --spp 1 --crop 80,60,4,3";
        ASSERT_EQ(plumb("render cornell_box -o a.exr" + of).exit_code, 0);
        const Image image = read_image(folder / "a.exr");
        std::vector<double> sums(12);
        for (int i = 0; i < 12; ++i) {
            const int x = i % 4, y = i / 4;
            const Json json = told("cornell_box " + std::to_string(80 + x) + ' ' + std::to_string(60 + y) + " 0" + of);
            sums[static_cast<std::size_t>(i)] += double(json["value"][0]);
            for (const Json& splat : json["splatted"])
                sums[static_cast<std::size_t>((int(splat["y"]) - 60) * 4 + int(splat["x"]) - 80)] +=
                    double(splat["value"][0]);
        }
        for (int i = 0; i < 12; ++i)
            EXPECT_EQ(static_cast<float>(sums[static_cast<std::size_t>(i)]), red(image, i % 4, i / 4)) << integrator;
    }
}

TEST_F(ExplainCommand, TakesItsOptionsFromThePicture) {
    ASSERT_EQ(
        plumb(
            "render glass --integrator path --sampler sobol --seed 3 --spp 16 --max-depth 6 --crop 90,140,8,8 -o a.exr")
            .exit_code,
        0);
    const Json by_hand =
        told("glass 92 143 5 --integrator path --sampler sobol --seed 3 --spp 16 --max-depth 6 --crop 90,140,8,8");
    EXPECT_EQ(told("a.exr 92 143 5"), by_hand);
    EXPECT_THAT(complaint("explain a.exr 92 143 5 --seed 3 --spp 4"), HasSubstr("a.exr says --spp, --seed itself"));
    EXPECT_THAT(complaint("explain a.exr 92"), HasSubstr("which pixel? Give x and y"));
    EXPECT_THAT(complaint("explain glass --fireflies"), HasSubstr("--fireflies is for a picture"));
}

TEST_F(ExplainCommand, TellsTheBrightestSampleFirst) {
    ASSERT_EQ(plumb("render glass --integrator path --seed 3 --spp 8 --crop 96,146,8,8 -o a.exr").exit_code, 0);
    const Json brightest = told("a.exr 100 150");
    double most = 0;
    for (int sample = 0; sample < 8; ++sample)
        most = std::max(most, told("a.exr 100 150 " + std::to_string(sample))["value"][1].get<double>());
    EXPECT_EQ(brightest["value"][1].get<double>(), most);
    const Said said = plumb("explain a.exr --fireflies");
    EXPECT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, AllOf(HasSubstr("brightest_sample"), HasSubstr("`plumb explain a.exr ")));
}

TEST_F(ExplainCommand, FactorsMultiplyUpToSplats) {
    for (const std::string call : {"--integrator path", "--integrator bdpt", "--integrator path --sampler sobol"})
        for (const std::string sample : {"0", "9", "15"}) {
            const Json json = told("glass 100 150 " + sample + " --seed 3 --spp 16 " + call);
            std::vector<double> sums(json["splats"].size());
            double value = 0;
            for (const Json& found : json["found"])
                if (!found["splat"].is_null())
                    sums[found["splat"]] +=
                        double(found["throughput"][1]) * double(found["value"][1]) * double(found["weight"]);
            for (std::size_t i = 0; i < sums.size(); ++i) {
                const double splat = json["splats"][i]["value"][1];
                EXPECT_NEAR(sums[i], splat, 1e-12 * splat) << call;
                if (!json["splats"][i]["anywhere"]) value += splat;
            }
            EXPECT_EQ(value, json["value"][1]) << call;
        }
}

TEST_F(ExplainCommand, ReadsWellAndTheSameTwice) {
    const std::string call = "explain cornell_box 64 100 3 --integrator path --seed 7";
    const Said said = plumb(call);
    EXPECT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, AllOf(HasSubstr("pixel 64,100, sample 3 of 64"), HasSubstr("shape 2 'back' (scene.xml:"),
                                HasSubstr("pdf per steradian"), HasSubstr("adds to the pixel: ")));
    EXPECT_EQ(plumb(call).out, said.out);
    const Said light = plumb("explain cornell_box 64 100 5 --integrator light --seed 7");
    EXPECT_THAT(light.out, AllOf(HasSubstr("light 0"), HasSubstr("pdf per area")));
}

TEST_F(ExplainCommand, TellsWhatTheDriverLetsASampleCount) {
    const std::string of = " --integrator direct --seed 7 --spp 64 --driver ";
    std::set<double> weights;
    for (int sample = 0; sample < 64; sample += 4) {  // of each pass one
        const Json json = told("quad_light 60 70 " + std::to_string(sample) + of + "frameless -P pixel-share=0.5");
        double sum = 0;
        for (const Json& splat : json["splats"]) sum += double(splat["value"][1]);
        EXPECT_NEAR(json["value"][1], sum * double(json["driver_weight"]), 1e-12);
        EXPECT_EQ(json["driver"], "frameless");
        EXPECT_EQ(json["parameters"]["pixel-share"], "0.5");
        weights.insert(double(json["driver_weight"]));
    }
    EXPECT_THAT(weights, ElementsAre(0, 2));
    EXPECT_EQ(told("quad_light 60 70 0" + of + "pixels")["driver_weight"], 1);
    EXPECT_THAT(plumb("explain quad_light 60 70 0" + of + "pixels").out, HasSubstr("driver pixels: takes the sample"));
}

TEST_F(ExplainCommand, FollowsThePassesOfTheRender) {
    const std::string call = "explain point_light 3 4 5 --integrator path --sampler sobol --seed 7 ";
    EXPECT_EQ(plumb(call + "--spp 128 --replicates 32 --json a.json").exit_code, 0);
    EXPECT_EQ(plumb(call + "--spp 64 --json b.json").exit_code, 0);  // passes of 4 both
    EXPECT_EQ(plumb(call + "--spp 128 --json c.json").exit_code, 0);
    const auto film = [&](const std::string& file) { return Json::parse(read(file))["film"]; };
    EXPECT_EQ(film("a.json"), film("b.json"));
    EXPECT_NE(film("a.json"), film("c.json"));
    EXPECT_THAT(complaint(call + "--spp 64 --replicates 3"), HasSubstr("64 samples a pixel in 3 replicates"));
}

TEST_F(ExplainCommand, NamesWhatIsWrong) {
    EXPECT_THAT(complaint("explain cornell_box 256 0 0"), HasSubstr("pixel 256,0: accepted are x from 0 to 255"));
    EXPECT_THAT(complaint("explain cornell_box 0 -- -1 0"), HasSubstr("pixel 0,-1"));
    EXPECT_THAT(complaint("explain cornell_box 3 4 0 --crop 0,0,2,2"), HasSubstr("x from 0 to 1"));
    EXPECT_THAT(complaint("explain cornell_box 3 4 64"), HasSubstr("sample 64 of 64 a pixel: accepted are 0 to 63"));
    EXPECT_THAT(complaint("explain cornel_box 3 4 0"), HasSubstr("did you mean 'cornell_box'"));
    EXPECT_THAT(complaint("explain cornell_box 3"), HasSubstr("which pixel? Give x and y"));
    EXPECT_THAT(complaint("explain cornell_box 3 four 0"), HasSubstr("four"));
    EXPECT_THAT(complaint("explain cornell_box 3 4 0 --integrator paht"), HasSubstr("did you mean 'path'"));
    EXPECT_THAT(complaint("explain cornell_box 3 4 0 --sampler halton"), HasSubstr("sobol"));
    EXPECT_THAT(complaint("explain cornell_box 3 4 0 --json /proc/a.json"), HasSubstr("/proc/a.json"));
}

}  // namespace
}  // namespace plumb::cli
