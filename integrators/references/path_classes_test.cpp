#include "integrators/references/path_classes.h"

#include <gmock/gmock.h>

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

Scene shipped(const std::string& name) {
    return Scene(load_mitsuba(scene_file(name)));
}

TEST(PathClasses, LeftOutIsLightOfPointsBehindMirrors) {
    Scene lamp = shipped("point_light");
    EXPECT_TRUE(left_out(path_makes, lamp, 4).empty());
    description::Scene with_glass = lamp.description();
    with_glass.materials.push_back({description::Dielectric{1.5, Spectrum::grey(1), Spectrum::grey(1), {}}, {}, {}});
    std::vector<std::string> names;
    for (const PathClass& path : left_out(path_makes, Scene(with_glass), 3)) names.push_back(to_string(path));
    EXPECT_THAT(names, testing::ElementsAre("EDSP"));
}

TEST(PathClasses, LightLeavesOutWhatTheLensSeesInMirrors) {
    const Scene glass = shipped("glass");
    EXPECT_TRUE(left_out(path_makes, glass, 4).empty());  // no point lights
    EXPECT_FALSE(left_out(light_makes, glass, 3).empty());
    EXPECT_TRUE(left_out(bdpt_makes, glass, 4).empty());
}

}  // namespace
}  // namespace plumb
