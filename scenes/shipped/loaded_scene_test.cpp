#include "scenes/shipped/loaded_scene.h"

#include "scenes/test_files.h"

namespace plumb {
namespace {

class LoadScene : public testing_files::Folder {
protected:
    /// A file whose sensor's film is $width pixels wide.
    [[nodiscard]] std::string scene_with_film() const {
        return write("a.xml",
                     "<scene version=\"3.0.0\"><default name=\"width\" value=\"20\"/><sensor "
                     "type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" "
                     "value=\"$width\"/><integer name=\"height\" value=\"10\"/></film></sensor></scene>")
            .string();
    }
};

TEST_F(LoadScene, KnowsItsNamesFileAndContent) {
    const LoadedScene shipped = load_scene("quad_light");
    EXPECT_EQ(shipped.asked, "quad_light");
    EXPECT_EQ(shipped.name(), "quad_light");
    EXPECT_EQ(shipped.file.filename(), "scene.xml");
    EXPECT_EQ(shipped.hash().size(), 16U);
    const std::string file = scene_with_film();
    const LoadedScene own = load_scene(file);
    EXPECT_EQ(own.asked, file);
    EXPECT_EQ(own.name(), "a");
    EXPECT_NE(own.hash(), shipped.hash());
    EXPECT_EQ(read_scene(file).hash(), own.hash()) << "before it is made ready";
    EXPECT_EQ(message([] { return load_scene("quad_lihgt").name(); }),
              "unknown scene 'quad_lihgt'; did you mean 'quad_light'?");
}

TEST_F(LoadScene, TakesDefinitionsWhichItsHashTells) {
    const std::string file = scene_with_film();
    const LoadedScene usual = load_scene(file), wide = load_scene(file, {.definitions = {{"width", "40"}}});
    EXPECT_EQ(usual.scene.sensor().film().width, 20);
    EXPECT_EQ(wide.scene.sensor().film().width, 40);
    EXPECT_EQ(wide.options.definitions.at("width"), "40");
    EXPECT_NE(wide.hash(), usual.hash());
}

TEST_F(LoadScene, HappensOnceForEachFile) {
    LoadedScenes scenes;
    const auto first = scenes.get("quad_light");
    EXPECT_EQ(scenes.get("quad_light"), first);
    EXPECT_EQ(scenes.get(first->file.string()), first);
    EXPECT_NE(scenes.get("point_light"), first);
}

}  // namespace
}  // namespace plumb
