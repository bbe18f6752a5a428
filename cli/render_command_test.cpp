#include <gmock/gmock.h>

#include "cli/command_test.h"
#include "core/images/image.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class RenderCommand : public CommandTest {
protected:
    [[nodiscard]] Image image(const std::string& name) const { return read_image(folder / name); }
};

std::size_t channel(const Image& image, const std::string& name) {
    const auto found = std::ranges::find(image.channels, name);
    EXPECT_NE(found, image.channels.end()) << name;
    return static_cast<std::size_t>(found - image.channels.begin());
}

TEST_F(RenderCommand, OfNothingIsRefused) {
    write("empty.xml", "<scene version=\"3.0.0\"><sensor type=\"perspective\"/></scene>");
    EXPECT_THAT(complaint("render empty.xml -o e.exr"), HasSubstr("empty.xml: has no shapes and no emitters"));
}

TEST_F(RenderCommand, SameSeedSameFileOnAnyNumberOfThreads) {
    for (const char* sampler : {"independent", "stratified", "sobol"}) {
        const std::string call = std::string("render quad_light --spp 4 --seed 7 --sampler ") + sampler;
        EXPECT_EQ(plumb(call + " --threads 1 -o a.exr").exit_code, 0);
        EXPECT_EQ(plumb(call + " --threads 2 -o b.exr").exit_code, 0);
        EXPECT_EQ(read("a.exr"), read("b.exr")) << sampler;
    }
}

TEST_F(RenderCommand, WritesLayersAndWhereTheyComeFrom) {
    ASSERT_EQ(plumb("render quad_light --spp 8 --seed 7 -o a.exr").exit_code, 0);
    const Image a = image("a.exr");
    EXPECT_EQ(a.width, 128);
    EXPECT_EQ(a.at(64, 80, channel(a, "samples")), 8);
    EXPECT_GT(a.at(64, 80, channel(a, "variance.R")), 0);
    EXPECT_NEAR(a.at(64, 80, channel(a, "albedo.G")), 0.5, 1e-6);
    EXPECT_NEAR(a.at(64, 80, channel(a, "normal.Y")), 1, 1e-6);
    EXPECT_GT(a.at(64, 80, channel(a, "depth.Z")), 3);
    EXPECT_EQ(a.metadata.at("plumb:integrator"), "direct");
    EXPECT_EQ(a.metadata.at("plumb:spp"), "8");
    EXPECT_EQ(a.metadata.at("plumb:scene_hash").size(), 16u);
    EXPECT_THAT(read("a.exr.json"), AllOf(HasSubstr("\"rays\""), HasSubstr("\"seconds\""), HasSubstr("\"nan\": 0")));
}

TEST_F(RenderCommand, ACropIsThatPartOfThePicture) {
    ASSERT_EQ(plumb("render quad_light --spp 2 --seed 7 -o whole.exr").exit_code, 0);
    ASSERT_EQ(plumb("render quad_light --spp 2 --seed 7 --crop 50,40,20,10 -o part.exr").exit_code, 0);
    const Image whole = image("whole.exr"), part = image("part.exr");
    ASSERT_EQ(part.width, 20);
    ASSERT_EQ(part.height, 10);
    for (const int x : {0, 7, 19})
        EXPECT_EQ(part.at(x, 9, channel(part, "R")), whole.at(50 + x, 49, channel(whole, "R")));
}

TEST_F(RenderCommand, ShardsMergeToTheSameFile) {
    for (const std::string integrator : {"path", "light"}) {
        const std::string call = "render quad_light --spp 12 --seed 7 --crop 50,40,20,10 --integrator " + integrator;
        ASSERT_EQ(plumb(call + " --threads 2 -o whole.exr").exit_code, 0);
        for (const char* shard : {"1", "2", "3"}) {
            const Said said = plumb(call + " --shard " + shard + "/3 --threads 1 -o " + shard + ".film");
            EXPECT_EQ(said.exit_code, 0) << said.error;
            EXPECT_THAT(said.out, HasSubstr("4 samples a pixel"));
        }
        ASSERT_EQ(plumb("merge 3.film 1.film 2.film -o merged.exr").exit_code, 0);
        EXPECT_EQ(read("merged.exr"), read("whole.exr")) << integrator;
        EXPECT_THAT(read("merged.exr.json"), HasSubstr("\"rays\""));
    }
}

TEST_F(RenderCommand, NamesPartsThatDoNotFit) {
    const std::string call = "render quad_light --spp 4 --crop 50,40,2,1 ";
    ASSERT_EQ(plumb(call + "--seed 7 --shard 1/2 -o 1.film").exit_code, 0);
    ASSERT_EQ(plumb(call + "--seed 8 --shard 2/2 -o other.film").exit_code, 0);
    ASSERT_EQ(plumb(call + "--seed 7 --shard 2/2 --rr-depth 3 -o deeper.film").exit_code, 0);
    ASSERT_EQ(plumb(call + "--seed 7 -o image.exr").exit_code, 0);
    EXPECT_THAT(complaint("merge 1.film -o a.exr"), HasSubstr("part 2 of 2 is missing"));
    EXPECT_THAT(complaint("merge 1.film 1.film -o a.exr"), HasSubstr("1.film: part 1 of 2, as is 1.film"));
    EXPECT_THAT(complaint("merge 1.film other.film -o a.exr"), HasSubstr("plumb:seed is '8', but '7'"));
    EXPECT_THAT(complaint("merge 1.film deeper.film -o a.exr"), HasSubstr("plumb:rr_depth"));
    EXPECT_THAT(complaint("merge 1.film image.exr -o a.exr"), HasSubstr("image.exr: not a part of a film"));
    EXPECT_THAT(complaint("merge 1.film"), HasSubstr("1.film"));
    EXPECT_THAT(complaint("merge 1.film -o a.nonsense"), HasSubstr("a.nonsense"));
    EXPECT_THAT(complaint(call + "--shard 1/2 -o a.film"), HasSubstr("--seed"));
    for (const char* shard : {"1/8", "5/8"})
        EXPECT_THAT(complaint(call + "--seed 7 -o a.film --shard " + shard), HasSubstr("8 parts of 4 passes"));
    EXPECT_THAT(complaint(call + "--seed 7 --shard 3/2 -o a.film"), HasSubstr("'3/2' is not a shard"));
    EXPECT_THAT(complaint("render quad_light --time 1s --seed 7 --shard 1/2 -o a.film"), HasSubstr("--time"));
}

TEST_F(RenderCommand, EndsWhenItsTimeIsOver) {
    const Said said = plumb("render quad_light --time 0.3s --crop 0,0,16,16 --seed 1 -o a.png");
    EXPECT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, HasSubstr("a.png"));
    EXPECT_EQ(image("a.png").channels.size(), 3u);
}

TEST_F(RenderCommand, EndsWhenItsErrorIsReached) {
    const Said said = plumb("render quad_light --error 5% --crop 40,40,32,32 --seed 1 -o a.exr");
    EXPECT_EQ(said.exit_code, 0) << said.error;
    EXPECT_THAT(said.out, HasSubstr("relative error "));
    const auto error = [&](const char* name) { return std::stod(image(name).metadata.at("plumb:error")); };
    EXPECT_LE(error("a.exr"), 0.05);
    EXPECT_GE(std::stoi(image("a.exr").metadata.at("plumb:replicates")), 16);
    EXPECT_EQ(plumb("render quad_light --error 5% --crop 40,40,32,32 --seed 1 --threads 1 -o b.exr").exit_code, 0);
    EXPECT_EQ(read("a.exr"), read("b.exr"));
    const Said missed = plumb("render quad_light --error 1e-9 --max-spp 100 --crop 40,40,32,32 -o c.exr");
    EXPECT_EQ(missed.exit_code, 3) << missed.error;
    EXPECT_THAT(missed.out, HasSubstr("the error RMSE 1e-09 was not reached with 100 samples a pixel (--max-spp)"));
    EXPECT_EQ(image("c.exr").metadata.at("plumb:spp"), "100");
    EXPECT_THAT(complaint("render quad_light --error 5% --spp 4 -o d.exr"), HasSubstr("--error"));
    EXPECT_THAT(complaint("render quad_light --error 5% --time 4s -o d.exr"), HasSubstr("--error"));
    EXPECT_THAT(complaint("render quad_light --max-spp 100 -o d.exr"), HasSubstr("--error"));
    EXPECT_THAT(complaint("render quad_light --error much -o d.exr"), HasSubstr("'much' is not an error"));
}

TEST_F(RenderCommand, FollowsTheIntegratorOfTheSceneUnlessAskedOtherwise) {
    const auto made_of = [&](const std::string& integrator, const std::string& options = "") {
        write("a.xml", "<scene version=\"3.0.0\">" + integrator + "<shape type=\"sphere\"/></scene>");
        const Said said = plumb("render a.xml --spp 1 --crop 0,0,2,2 -o a.exr " + options);
        EXPECT_EQ(said.exit_code, 0) << said.error;
        const auto metadata = image("a.exr").metadata;
        return metadata.at("plumb:integrator") + " " + metadata.at("plumb:max_depth") + " " +
               (said.out.find("not followed: integrator") == std::string::npos ? "followed" : "not followed");
    };
    const std::string path = "<integrator type=\"path\"><integer name=\"max_depth\" value=\"3\"/></integrator>";
    EXPECT_EQ(made_of(path), "path 3 followed");
    EXPECT_EQ(made_of(path, "--max-depth 5"), "path 5 followed");
    EXPECT_EQ(made_of(path, "--integrator bdpt"), "bdpt -1 followed");
    EXPECT_EQ(made_of("<integrator type=\"direct\"/>"), "direct -1 followed");
    EXPECT_EQ(made_of("<integrator type=\"ptracer\"/>"), "light -1 followed");
    EXPECT_EQ(made_of(""), "path -1 followed");
    EXPECT_EQ(made_of("<integrator type=\"volpath\"/>"), "path -1 not followed");
}

TEST_F(RenderCommand, NamesWhatIsWrong) {
    EXPECT_THAT(complaint("render quad_ligth -o a.exr"), HasSubstr("did you mean 'quad_light'"));
    EXPECT_THAT(complaint("render missing.xml -o a.exr"), HasSubstr("missing.xml"));
    EXPECT_THAT(complaint("render quad_light --integrator paht -o a.exr"), HasSubstr("did you mean 'path'"));
    EXPECT_THAT(complaint("render quad_light --sampler halton -o a.exr"), HasSubstr("sobol"));
    EXPECT_THAT(complaint("render quad_light --crop 120,0,20,20 -o a.exr"), HasSubstr("film of 128 x 96"));
    EXPECT_THAT(complaint("render quad_light --spp 0 -o a.exr"), HasSubstr("--spp"));
    EXPECT_THAT(complaint("render quad_light --spp 4 --time 3s -o a.exr"), HasSubstr("--time"));
    EXPECT_THAT(complaint("render quad_light -D size=3 --spp 1 -o a.exr"), HasSubstr("size"));
    EXPECT_THAT(complaint("render quad_light --spp 1 -o /proc/a.exr"), HasSubstr("/proc/a.exr"));
    EXPECT_THAT(complaint("render quad_light --spp 1 --crop 0,0,4,4 -o a.nonsense"), HasSubstr("a.nonsense"));
    write("bad.xml", "<scene version=\"3.0.0\">\n<shape type=\"torus\"/>\n</scene>\n");
    EXPECT_THAT(complaint("render bad.xml -o a.exr"), StartsWith("plumb: bad.xml:2: unknown shape 'torus'"));
}

}  // namespace
}  // namespace plumb::cli
