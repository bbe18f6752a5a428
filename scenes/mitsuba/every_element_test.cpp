// Nothing that a scene file says is silently dropped: every element of every shipped scene, misspelt, doubled, moved or
// without its name, is an error; and so is what else nobody reads.

#include <pugixml.hpp>

#include <sstream>

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/scene.h"
#include "scenes/shipped/shipped.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

class EveryElement : public testing_files::Folder {
protected:
    std::string says(const std::string& text) const {
        return message([&] { return load_mitsuba(write("scene.xml", text)); });
    }
    std::string says_of(const std::string& body) const {
        return says("<scene version=\"3.0.0\">\n" + body + "</scene>");
    }

    /// The scene's other files at hand, a small mesh in place of the one with a million triangles.
    void link_files_of(const fs::path& scene) const {
        for (const auto& entry : fs::directory_iterator(scene.parent_path()))
            if (entry.path().extension() != ".xml") fs::create_symlink(entry.path(), path_ / entry.path().filename());
        fs::remove(path_ / "terrain.ply");
        write("terrain.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    }
    /// Whether a scene in which one element was changed is refused. What the scene makes of itself may refuse it too.
    bool refused(const pugi::xml_document& document) const {
        std::ostringstream text;
        document.save(text);
        return message([&] { return Scene(load_mitsuba(write("scene.xml", text.str()))); }) != "nothing";
    }
};

std::vector<pugi::xml_node> elements_of(const pugi::xml_node& root) {
    std::vector<pugi::xml_node> all;
    for (const pugi::xml_node& child : root.children()) {
        if (child.type() != pugi::node_element) continue;
        all.push_back(child);
        for (const pugi::xml_node& inner : elements_of(child)) all.push_back(inner);
    }
    return all;
}

/// Whether two of it may stand where one does: things in a scene, sides of a surface, steps of a transform.
bool may_be_doubled(const pugi::xml_node& element) {
    const std::string tag = element.name(), parent = element.parent().name();
    return parent == "transform" ||
           (parent == "scene" && !element.attribute("id") && tag != "default" && tag != "integrator") ||
           std::string(element.parent().attribute("type").value()) == "twosided";
}

/// Calls `change` with each element of a fresh copy of the scene; counts the changed scenes that load all the same.
template <class Change>
std::vector<std::string> accepted_changes(const fs::path& scene, const auto& refused, const Change& change) {
    std::vector<std::string> accepted;
    pugi::xml_document original;
    original.load_file(scene.c_str());
    const std::size_t count = elements_of(original.document_element()).size();
    for (std::size_t i = 0; i < count; ++i) {
        pugi::xml_document document;
        document.reset(original);
        const pugi::xml_node element = elements_of(document.document_element())[i];
        const std::string name = element.path();
        if (change(element) && !refused(document)) accepted.push_back(name);
    }
    return accepted;
}

TEST_F(EveryElement, OfShippedScenesCounts) {
    for (const std::string name :
         {"glass", "interior", "lens_focus", "million_triangles", "point_light", "veach_plates"}) {
        SCOPED_TRACE(name);
        const fs::path scene = scene_file(name);
        for (const auto& entry : fs::directory_iterator(path_)) fs::remove(entry.path());
        link_files_of(scene);
        const auto accepted = [&](const auto& change) {
            return accepted_changes(
                scene, [&](const auto& document) { return refused(document); }, change);
        };
        const std::vector<std::string> none;
        EXPECT_EQ(accepted([](pugi::xml_node element) {
                      return element.set_name((element.name() + std::string("x")).c_str());
                  }),
                  none)
            << "misspelt";
        EXPECT_EQ(accepted([](pugi::xml_node element) {
                      pugi::xml_attribute last = element.last_attribute();
                      return last && last.set_name((last.name() + std::string("x")).c_str());
                  }),
                  none)
            << "attributes misspelt";
        EXPECT_EQ(accepted([](pugi::xml_node element) {
                      return !may_be_doubled(element) && element.parent().insert_copy_after(element, element);
                  }),
                  none)
            << "doubled";
        EXPECT_EQ(accepted([](pugi::xml_node element) {
                      const bool moves = std::string(element.parent().name()) != "scene" && !element.attribute("id");
                      return moves && element.root().first_child().append_move(element);
                  }),
                  none)
            << "moved to the root";
        EXPECT_EQ(accepted([](pugi::xml_node element) {
                      // A thing within another may have a name and needs none.
                      return std::string(element.name()) != "rfilter" && element.remove_attribute("name");
                  }),
                  none)
            << "without its name";
    }
}

TEST_F(EveryElement, OrItIsAnErrorThatNamesWhatIsAccepted) {
    const auto shape = [](const std::string& inner) { return "<shape type=\"sphere\">" + inner + "</shape>"; };
    const auto bsdf = [](const std::string& type, const std::string& inner) {
        return "<bsdf type=\"" + type + "\" id=\"a\">" + inner + "</bsdf>";
    };
    const std::string board = "<texture type=\"checkerboard\"/>",
                      named_board = "<texture type=\"checkerboard\" name=\"alpha\"/>";
    const std::vector<std::pair<std::string, std::string>> cases{
        {bsdf("diffuse", board),
         "scene.xml:2: <texture> without a name within diffuse; accepted are values by the names"},
        {bsdf("diffuse", "<rgb value=\"1\"/>"), "scene.xml:2: <rgb> without a name within diffuse; accepted are"},
        {bsdf("diffuse", "<bsdf type=\"diffuse\"/>"),
         "scene.xml:2: <bsdf> within diffuse, where nothing takes it; accepted are"},
        {bsdf("diffuse", "<rgb name=\"reflectance\" value=\"1\" scale=\"2\"/>"),
         "scene.xml:2: unknown attribute of <rgb> 'scale'"},
        {bsdf("diffuse", "<flaot name=\"reflectance\" value=\"1\"/>"),
         "scene.xml:2: reflectance is a <flaot>; accepted is"},
        {bsdf("roughconductor", named_board),
         "scene.xml:2: alpha is a <texture>; accepted is a number (<float>, <integer>)"},
        {bsdf("conductor", "<spectrum name=\"eta\" filename=\"a.spd\"/><rgb name=\"k\" value=\"1\"/>"),
         "scene.xml:2: a spectrum from a file; one number"},
        {shape("<emitter type=\"area\"><blackbody name=\"radiance\" temperature=\"5000\"/></emitter>"),
         "scene.xml:2: radiance is a <blackbody>; accepted is a constant"},
        {shape("<bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/>"),
         "scene.xml:2: 2 bsdf elements in sphere; one is accepted"},
        {shape("<transform><translate x=\"1\"/></transform>"),
         "scene.xml:2: <transform> without a name within sphere; accepted"},
        {shape("<transform name=\"to_world\"><translate X=\"1\"/></transform>"),
         "scene.xml:2: unknown attribute of <translate> 'X'; did you mean 'x'?"},
        {shape("<transform name=\"to_world\"><scale value=\"2\" x=\"1\"/></transform>"),
         "scene.xml:2: value and x of <scale> are given; one way is accepted"},
        {"<bsdf type=\"diffuse\"/>", "scene.xml:2: bsdf 'diffuse' at the root without an id"},
        {shape("text"), "scene.xml:2: the text 'text' within <shape>; elements are accepted"},
    };
    for (const auto& [body, expected] : cases) EXPECT_EQ(says_of(body).substr(0, expected.size()), expected) << body;
}

TEST_F(EveryElement, ConductorsOfNoMetalFollowTheVersion) {
    const std::string body = "<bsdf type=\"conductor\" id=\"a\"/></scene>";
    const auto metal = [&](const std::string& version) {
        const auto scene = load_mitsuba(write("a.xml", "<scene version=\"" + version + "\">" + body));
        return std::get<description::Conductor>(scene.materials.at(0).kind).eta;
    };
    EXPECT_TRUE(metal("0.6.0"));
    EXPECT_FALSE(metal("3.0.0"));
    EXPECT_EQ(says("<scene>" + body).substr(0, 40), "scene.xml:1: a conductor of no metal, wh");
}

TEST_F(EveryElement, FilesAreFoundBesideTheirFileThenInTheMainFolder) {
    fs::create_directory(path_ / "parts");
    write("here.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("parts/there.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto part = [&](const std::string& mesh) {
        write("parts/p.xml",
              "<scene><shape type=\"obj\"><string name=\"filename\" value=\"" + mesh + "\"/></shape></scene>");
        return says_of("<include filename=\"parts/p.xml\"/>");
    };
    EXPECT_EQ(part("here.obj"), "nothing");
    EXPECT_EQ(part("there.obj"), "nothing");
    EXPECT_EQ(part("no.obj"), "parts/p.xml:1: there is no file parts/no.obj nor no.obj");
}

TEST_F(EveryElement, TexturesTakeBothSizesOfMatrix) {
    const auto at = [&](const std::string& matrix) {
        const auto scene = load_mitsuba(
            write("a.xml", "<scene><texture type=\"checkerboard\" id=\"t\"><transform name=\"to_uv\"><matrix value=\"" +
                               matrix + "\"/></transform></texture></scene>"));
        return scene.textures.at(0).to_uv.point({0.25, 0.5, 0});
    };
    const Vec3 nine = at("2 1 0.5  0 3 0.25  0 0 1"), sixteen = at("2 1 0 0.5  0 3 0 0.25  0 0 1 0  0 0 0 1");
    EXPECT_EQ(nine, (Vec3{1.5, 1.75, 0}));
    EXPECT_EQ(nine, sixteen);
    EXPECT_THROW(at("2 1 0.5 0  0 3 0.25 0  0 0 1 0  0 0 0 1"), Error);
}

TEST_F(EveryElement, ASceneWithoutASensorIsSeenWhole) {
    const auto scene = load_mitsuba(write("a.xml", "<scene><shape type=\"sphere\"/></scene>"));
    EXPECT_EQ(scene.notes.size(), 1u);
    EXPECT_LT(scene.sensor.value().to_world.point({}).z, -1);
}

}  // namespace
}  // namespace plumb
