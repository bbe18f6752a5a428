#include "scenes/mitsuba/mitsuba_xml.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/file.h"
#include "core/random.h"
#include "scenes/mitsuba/loader.h"
#include "scenes/mitsuba/plugins.h"

namespace plumb {

namespace mitsuba {

void Loader::ignored(const description::Place& place, std::string text) {
    scene.notes.push_back({description::Note::Kind::ignored, place, std::move(text)});
}

void Loader::replaced(const description::Place& place, std::string text, const Error& error) {
    if (!options.lenient) throw error;
    scene.notes.push_back({description::Note::Kind::replaced, place, std::move(text)});
}

Error Loader::unknown_plugin(const XmlElement& element) const {
    return element.place.error(fmt::format("unknown {} '{}'; there are {}", element.tag, element.attribute("type"),
                                           fmt::join(plugin_names(element.tag), ", ")));
}

namespace {

/// Whether it is a shape's emitter that stands at the root for shapes to refer to.
bool is_for_shapes(const XmlElement& element, const Loader& loader) {
    return element.tag == "emitter" && element.has("id") && loader.referred.contains(element.attribute("id")) &&
           description::serves<description::AreaEmitter>(element.attribute("type"));
}

void load_element(const XmlElement& element, Loader& loader) {
    description::Scene& scene = loader.scene;
    if (element.tag == "shape") {
        scene.shapes.push_back(load_shape(element, loader));
    } else if (element.tag == "bsdf") {
        load_material(element, loader);
    } else if (element.tag == "texture") {
        load_texture(element, loader);
    } else if (is_for_shapes(element, loader)) {
        return;
    } else if (element.tag == "emitter") {
        scene.emitters.push_back(load_emitter(element, loader));
    } else if (element.tag == "sensor") {
        description::Sensor sensor = load_sensor(element, loader);
        if (scene.sensor)
            loader.ignored(element.place, "another sensor");
        else
            scene.sensor = std::move(sensor);
    } else if (element.tag == "integrator") {
        scene.integrator = load_integrator(element, loader);
    } else {
        return;
    }
    element.reading.taken = true;
}

void load_elements(const XmlElement& root, Loader& loader) {
    root.reading.parts = {"alias",      "bsdf", "default", "emitter", "include",
                          "integrator", "path", "sensor",  "shape",   "texture"};
    for (const XmlElement& element : root.children)
        if (!element.reading.left_out) load_element(element, loader);
    report_unread(root, loader);
}

void accept_one(const XmlElement& root, const std::string& tag) {
    const XmlElement* first = nullptr;
    for (const XmlElement& child : root.children) {
        if (child.tag != tag) continue;
        if (first)
            throw child.place.error(
                fmt::format("a second {}; the first is in {}", tag, as_seen_from(first->place, child.place)));
        first = &child;
    }
}

void report_unused_names(const std::vector<XmlElement>& unused, Loader& loader) {
    for (const XmlElement& element : unused)
        loader.ignored(element.place,
                       fmt::format("the default of ${}, for which nothing asks", element.attribute("name")));
}

void append_text(const XmlElement& element, std::optional<int> around, std::string& text) {
    text += '<' + element.tag;
    // An included file may have a version of its own.
    if (element.version != around) text += fmt::format(" version {}", element.version.value_or(-1));
    for (const auto& [name, value] : element.attributes) text += ' ' + name + '=' + value;
    for (const XmlElement& child : element.children) append_text(child, element.version, text);
    text += '>';
}

// The hash of the content: where the files lie does not matter, only what is in them.
std::uint64_t content_hash(const XmlElement& root, const Loader& loader) {
    std::string text;
    append_text(root, root.version, text);
    for (const auto& file : loader.files) text += fmt::format(" {:x}", stream_id(read_file(file)));
    return stream_id(text);
}

}  // namespace

}  // namespace mitsuba

description::Scene load_mitsuba(const std::filesystem::path& file, const LoadOptions& options) {
    const XmlTree tree = read_xml_tree(file, options.definitions);
    const XmlElement& root = tree.root;
    mitsuba::Loader loader{.options = options, .folders = tree.folders};
    mitsuba::report_unknown_tags(root, loader);
    mitsuba::index_references(root, loader);
    mitsuba::accept_one(root, "integrator");
    mitsuba::load_elements(root, loader);
    mitsuba::report_unreferred(root, loader);
    mitsuba::report_unused_names(tree.unused_names, loader);
    if (!loader.scene.sensor) loader.scene.sensor = mitsuba::default_sensor(root, loader);
    loader.scene.content_hash = mitsuba::content_hash(root, loader);
    return std::move(loader.scene);
}

}  // namespace plumb
