#include "scenes/shipped/shipped.h"

#include "core/file.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/known_radiances.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

using description::Note;
using description::Scene;

TEST(ShippedScenes, LoadAsTheyStandAndAskTheirQuestion) {
    const std::vector<ShippedScene> scenes = shipped_scenes();
    EXPECT_GE(scenes.size(), 17u);
    for (const auto& [name, question, file] : scenes) {
        const Scene scene = load_mitsuba(file);
        ASSERT_TRUE(scene.sensor) << name;
        for (const Note& note : scene.notes) EXPECT_EQ(note.kind, Note::Kind::ignored) << name << ": " << note.text;
        const KnownScene known = known_radiances(file.parent_path() / "expected.json");
        EXPECT_EQ(known.film.width, scene.sensor->film.width) << name;
        EXPECT_EQ(known.film.height, scene.sensor->film.height) << name;
        EXPECT_FALSE(known.radiances.empty()) << name;
        EXPECT_TRUE(question.ends_with("?")) << name;
        EXPECT_TRUE(read_file(file).starts_with("<!-- " + question)) << name;
    }
}

class SceneFile : public testing_files::Folder {};

TEST_F(SceneFile, IsAPathOrAName) {
    const auto file = write("a.xml", "");
    EXPECT_EQ(scene_file(file.string()), file);
    EXPECT_EQ(scene_file("glass").parent_path().filename(), "glass");
    EXPECT_EQ(message([] { return scene_file("glas"); }), "unknown scene 'glas'; did you mean 'glass'?");
    EXPECT_EQ(message([] { return scene_file("no/glass.xml"); }), "there is no scene file no/glass.xml");
    EXPECT_EQ(
        message([] { return scene_file("xylophones-and-more"); }).find("unknown scene 'xylophones-and-more'; known: "),
        0u);
}

}  // namespace
}  // namespace plumb
