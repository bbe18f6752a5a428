#include <gmock/gmock.h>

#include "cli/command_test.h"
#include "core/images/image.h"

namespace plumb::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ReferenceCommand : public CommandTest {
protected:
    void SetUp() override { write_scene(1); }
    /// A lamp of this radiance over a floor.
    void write_scene(double radiance) const {
        write("lamp.xml", R"(<scene version="3.0.0">
            <sensor type="perspective"><float name="fov" value="40"/>
                <transform name="to_world"><lookat origin="0, 3, -6" target="0, 0, 0" up="0, 1, 0"/></transform>
                <film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="16"/>
                    <rfilter type="box"/></film></sensor>
            <shape type="rectangle"><transform name="to_world"><scale value="9"/><rotate x="1" angle="-90"/></transform>
                <bsdf type="diffuse"><rgb name="reflectance" value="0.5"/></bsdf></shape>
            <shape type="sphere"><point name="center" x="0" y="2" z="0"/><float name="radius" value="0.5"/>
                <emitter type="area"><rgb name="radiance" value=")" +
                              std::to_string(radiance) + R"("/></emitter></shape></scene>)");
    }
    [[nodiscard]] std::vector<std::string> references() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "out/references"))
            if (entry.path().extension() == ".exr") names.push_back(entry.path().filename());
        return names;
    }
};

TEST_F(ReferenceCommand, IsKeptUntilTheSceneChangesOrMoreIsAsked) {
    ASSERT_EQ(plumb("reference lamp.xml --error 5% --seed 1").exit_code, 0);
    ASSERT_EQ(references().size(), 1u);
    const std::string file = references()[0];
    EXPECT_THAT(file, AllOf(testing::StartsWith("lamp-"), testing::EndsWith("-path.exr")));
    const auto error = [&] {
        return std::stod(read_image(folder / "out/references" / file).metadata.at("plumb:error"));
    };
    const std::string before = read("out/references/" + file);
    EXPECT_LE(error(), 0.05);

    const Said again = plumb("reference lamp.xml --error 5%");
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_THAT(again.out, AllOf(HasSubstr("nothing to do"), HasSubstr("seed 1")));
    EXPECT_EQ(read("out/references/" + file), before);

    const Said more = plumb("reference lamp.xml --error " + std::to_string(40 * error()) + "% --seed 2");
    EXPECT_EQ(more.exit_code, 0) << more.out << more.error;
    EXPECT_THAT(more.out, HasSubstr("rendered anew"));
    EXPECT_NE(read("out/references/" + file), before);
    const Said missed = plumb("reference lamp.xml --error 1e-9 --max-spp 64");
    EXPECT_EQ(missed.exit_code, 3) << missed.out << missed.error;
    EXPECT_THAT(missed.out, HasSubstr("more needs a larger --max-spp"));

    EXPECT_EQ(plumb("reference lamp.xml --error 5% --max-depth 2").exit_code, 0);
    EXPECT_EQ(references().size(), 2u);
    write_scene(2);
    EXPECT_EQ(plumb("reference lamp.xml --error 5%").exit_code, 0);
    EXPECT_EQ(references().size(), 3u);
}

TEST_F(ReferenceCommand, IsWhatOthersAreMeasuredAgainst) {
    ASSERT_EQ(plumb("reference lamp.xml --error 1% --max-depth 2 --seed 1").exit_code, 0);
    const Said converged = plumb(
        "converge direct direct-emitters --on lamp.xml --n 64,256 --replicates 20 --seed 5 "
        "--reference auto --json c.json");
    EXPECT_EQ(converged.exit_code, 0) << converged.error;
    EXPECT_THAT(converged.out, HasSubstr("truth of lamp.xml: out/references/lamp-"));
    EXPECT_THAT(read("c.json"), AllOf(HasSubstr("\"truths\""), HasSubstr("own variance is subtracted")));

    ASSERT_EQ(plumb("render lamp.xml --integrator direct --spp 64 --seed 2 -o a.exr").exit_code, 0);
    const Said compared = plumb("compare a.exr lamp.xml --delta 10% --tile-delta 60% --report c.html");
    EXPECT_THAT(compared.exit_code, testing::AnyOf(0, 3)) << compared.out << compared.error;  // of tails at the lamp
    EXPECT_THAT(read("c.html"), HasSubstr("lamp-"));

    write_scene(2);
    EXPECT_THAT(complaint("compare a.exr lamp.xml"), HasSubstr("a.exr: is of another scene than lamp"));
}

TEST_F(ReferenceCommand, NamesWhatIsWrong) {
    EXPECT_THAT(complaint("reference lamp.xml"), HasSubstr("--error"));
    EXPECT_THAT(complaint("reference lamp.xml --error 5% --integrator aov"), HasSubstr("'aov'"));
    EXPECT_THAT(complaint("reference lamp.xml --error 5% --integrator paht"), HasSubstr("did you mean 'path'"));
    for (const char* verb : {"reference lamp.xml --error 5%", "render lamp.xml", "explain lamp.xml 1 1 0"})
        EXPECT_THAT(complaint(std::string(verb) + " --integrator direct --max-depth 3"),
                    HasSubstr("accepted are 2 and -1"));
    EXPECT_THAT(complaint("reference lump.xml --error 5%"), HasSubstr("lump.xml"));
    EXPECT_THAT(complaint("reference lamp.xml --error 5% --cache /proc/none"), HasSubstr("/proc/none"));
    const std::string converge = "converge path --on lamp.xml --n 64 --replicates 4 --report c.html --reference ";
    EXPECT_THAT(
        complaint(converge + "auto"),
        HasSubstr(
            "there is no reference of lamp.xml in out/references; make one by: plumb reference lamp.xml --error"));
    EXPECT_THAT(complaint(converge + "none.exr"), HasSubstr("none.exr"));
    EXPECT_THAT(complaint("converge independent --on exp --reference auto"), HasSubstr("--reference for 'exp'"));
    EXPECT_THAT(complaint("converge path direct --on lamp.xml --n 64 --reference auto"), HasSubstr("path and direct"));
    ASSERT_EQ(plumb("render lamp.xml --integrator path --spp 32 --seed 2 -o a.exr").exit_code, 0);
    ASSERT_EQ(plumb("render quad_light --integrator path --spp 4 --crop 0,0,24,16 -o other.exr").exit_code, 0);
    ASSERT_EQ(plumb("render lamp.xml --integrator path --spp 32 --crop 0,0,8,8 -o part.exr").exit_code, 0);
    EXPECT_THAT(complaint("compare a.exr lamp.xml"), HasSubstr("there is no reference of lamp.xml"));
    ASSERT_EQ(plumb("render lamp.xml --integrator path --length 2 --spp 4 -o length.exr").exit_code, 0);
    EXPECT_THAT(complaint("compare length.exr lamp.xml"), HasSubstr("length.exr: an image of `path`, or of one"));
    EXPECT_THAT(complaint(converge + "other.exr"), HasSubstr("other.exr: is of another scene than lamp"));
    EXPECT_THAT(complaint(converge + "part.exr"), HasSubstr("part.exr: is 8x8 pixels, the film 24x16"));
    EXPECT_THAT(complaint("converge direct --on lamp.xml --n 64 --reference a.exr"), HasSubstr("lengths of paths"));
}

}  // namespace
}  // namespace plumb::cli
