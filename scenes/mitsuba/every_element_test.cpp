// Nothing that a scene file says is silently dropped: every element of every shipped scene, misspelt, doubled, moved or
// without its name, is an error.

#include <pugixml.hpp>

#include <algorithm>
#include <set>
#include <sstream>

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/scene.h"
#include "scenes/shipped/shipped.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::string attribute(const pugi::xml_node& element, const char* name) {
    return element.attribute(name).value();
}

/// What the element is, and what it stands in. Of elements alike in this a scene has one tried: 48 lamps are one.
std::string kind_of(const pugi::xml_node& element) {
    std::string kind;
    for (pugi::xml_node node = element; node.type() == pugi::node_element; node = node.parent()) {
        kind += std::string("<") + node.name();
        for (const pugi::xml_attribute& each : node.attributes()) {
            kind += std::string(" ") + each.name();
            if (const std::string name = each.name(); name == "type" || name == "name")
                kind += std::string("=") + each.value();
        }
    }
    return kind;
}

std::vector<pugi::xml_node> elements_of(const pugi::xml_node& root) {
    std::vector<pugi::xml_node> all;
    for (const pugi::xml_node& child : root.children()) {
        if (child.type() != pugi::node_element) continue;
        all.push_back(child);
        for (const pugi::xml_node& inner : elements_of(child)) all.push_back(inner);
    }
    return all;
}

class EveryElement : public testing_files::Folder {
protected:
    /// Tries the change on each kind of element of each shipped scene; the elements with which the scene loads all the
    /// same. A change is false where it does not apply.
    template <class Change>
    std::vector<std::string> accepted(const Change& change) const {
        std::vector<std::string> all;
        for (const ShippedScene& scene : shipped_scenes()) {
            link_files_of(scene.file);
            pugi::xml_document original;
            original.load_file(scene.file.c_str());
            std::set<std::string> kinds;
            const std::size_t count = elements_of(original.document_element()).size();
            for (std::size_t i = 0; i < count; ++i) {
                if (!kinds.insert(kind_of(elements_of(original.document_element())[i])).second) continue;
                pugi::xml_document document;
                document.reset(original);
                const pugi::xml_node element = elements_of(document.document_element())[i];
                const std::string name = scene.file.parent_path().filename().string() + element.path();
                if (change(element) && loads(document)) all.push_back(name);
            }
        }
        return all;
    }

private:
    /// The scene's other files at hand, a small mesh in place of the one with a million triangles.
    void link_files_of(const fs::path& scene) const {
        for (const auto& entry : fs::directory_iterator(path_)) fs::remove(entry.path());
        for (const auto& entry : fs::directory_iterator(scene.parent_path()))
            if (entry.path().extension() != ".xml") fs::create_symlink(entry.path(), path_ / entry.path().filename());
        fs::remove(path_ / "terrain.ply");
        write("terrain.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    }
    /// Whether the program would render it: some is refused only when the scene is made of what the file says.
    bool loads(const pugi::xml_document& document) const {
        std::ostringstream text;
        document.save(text);
        return message([&] { return Scene(load_mitsuba(write("scene.xml", text.str()))); }) == "nothing";
    }
};

const std::vector<std::string> none;

TEST_F(EveryElement, UnchangedLoads) {
    // Or the other tests would say nothing.
    const std::size_t scenes = shipped_scenes().size();
    EXPECT_EQ(
        accepted([](pugi::xml_node element) { return element == element.root().first_child().first_child(); }).size(),
        scenes);
}

TEST_F(EveryElement, MisspeltIsAnError) {
    EXPECT_EQ(
        accepted([](pugi::xml_node element) { return element.set_name((element.name() + std::string("x")).c_str()); }),
        none);
}

TEST_F(EveryElement, WithAMisspeltAttributeIsAnError) {
    for (const std::size_t which : {0u, 1u, 2u, 3u})
        EXPECT_EQ(accepted([&](pugi::xml_node element) {
                      const auto attributes = element.attributes();
                      if (std::cmp_less_equal(std::distance(attributes.begin(), attributes.end()), which)) return false;
                      pugi::xml_attribute changed = *std::next(attributes.begin(), static_cast<std::ptrdiff_t>(which));
                      return changed.set_name((changed.name() + std::string("x")).c_str());
                  }),
                  none)
            << which;
}

TEST_F(EveryElement, WithAForeignAttributeIsAnError) {
    EXPECT_EQ(accepted([](pugi::xml_node element) { return element.append_attribute("scale").set_value("2"); }), none);
}

TEST_F(EveryElement, WithAMisspeltNameIsAnError) {
    EXPECT_EQ(accepted([](pugi::xml_node element) {
                  // Things may have a name and need none: nobody asks what it is.
                  const bool is_value = element.attribute("name") && element.name() != std::string("rfilter");
                  return is_value && element.attribute("name").set_value((attribute(element, "name") + "x").c_str());
              }),
              none);
}

TEST_F(EveryElement, WithoutItsNameIsAnError) {
    EXPECT_EQ(accepted([](pugi::xml_node element) {
                  return element.name() != std::string("rfilter") && element.remove_attribute("name");
              }),
              none);
}

TEST_F(EveryElement, DoubledIsAnError) {
    // Two may stand where one does of: things in a scene, sides of a surface, steps of a transform.
    const auto may_be_two = [](const pugi::xml_node& element) {
        const std::string tag = element.name(), parent = element.parent().name(), type = attribute(element, "type");
        const bool is_thing = tag == "shape" || tag == "sensor" || (tag == "emitter" && type == "point");
        return parent == "transform" || (parent == "scene" && is_thing && !element.attribute("id")) ||
               attribute(element.parent(), "type") == "twosided";
    };
    EXPECT_EQ(accepted([&](pugi::xml_node element) {
                  return !may_be_two(element) && element.parent().insert_copy_after(element, element);
              }),
              none);
}

TEST_F(EveryElement, MovedIsAnError) {
    const std::set<std::string> at_home_anywhere{"default"}, at_home_in_shapes{"bsdf", "emitter", "ref"};
    const std::vector<std::string> places{"/scene",       "/scene/integrator", "/scene/sensor", "/scene/sensor/film",
                                          "/scene/shape", "//transform"};
    for (const std::string& place : places)
        EXPECT_EQ(accepted([&](pugi::xml_node element) {
                      const pugi::xml_node to = element.root().select_node(place.c_str()).node();
                      const std::string tag = element.name();
                      if (!to || at_home_anywhere.contains(tag)) return false;
                      if (element.parent().name() == std::string(to.name())) return false;
                      if (place == "/scene" && element.attribute("id")) return false;
                      if (place == "/scene/shape" && at_home_in_shapes.contains(tag)) return false;
                      if (place == "/scene/shape" && attribute(element, "name") == "to_world") return false;
                      return !pugi::xml_node(to).append_move(element).empty();
                  }),
                  none)
            << "to " << place;
}

}  // namespace
}  // namespace plumb
