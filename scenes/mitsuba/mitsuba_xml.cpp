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

const XmlElement& Loader::resolve(const XmlElement& element) const {
    if (element.tag != "ref") return element;
    const std::string& id = element.attribute("id");
    const auto found = named.find(id);
    if (found != named.end()) return *found->second;
    std::vector<std::string> known;
    for (const auto& [other, target] : named) known.push_back(other);
    const std::string near = nearest_name(id, known);
    throw element.place.error(fmt::format("<ref> to '{}', but nothing has this id{}", id,
                                          near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

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

void index_ids(const XmlElement& element, Loader& loader) {
    for (const XmlElement& child : element.children) {
        index_ids(child, loader);
        // Whether an id is accepted is up to whoever reads the element.
        const auto id = child.attributes.find("id");
        if (id == child.attributes.end()) continue;
        if (child.tag == "ref" || child.tag == "alias") {
            loader.referred.insert(id->second);
            continue;
        }
        const auto [found, is_new] = loader.named.try_emplace(id->second, &child);
        if (!is_new) {
            const description::Place& first = found->second->place;
            throw child.place.error(fmt::format("the id '{}' is taken by {}", id->second,
                                                first.file == child.place.file
                                                    ? fmt::format("line {}", first.line)
                                                    : fmt::format("{}:{}", first.file, first.line)));
        }
    }
}

// <alias id="a" as="b"/>: b is another name of a, which stands before it.
void index_aliases(const XmlElement& root, Loader& loader) {
    for (const XmlElement& child : root.children) {
        if (child.tag != "alias") continue;
        const auto found = loader.named.find(child.attribute("id"));
        if (found == loader.named.end())
            throw child.place.error(fmt::format("<alias> of '{}', but nothing has this id", child.attribute("id")));
        if (!loader.named.try_emplace(child.attribute("as"), found->second).second)
            throw child.place.error(fmt::format("the id '{}' is taken", child.attribute("as")));
        child.reading.taken = true;
    }
}

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
        pass_over(element, loader);
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
        if (first) throw child.place.error(fmt::format("a second {}; the first is in line {}", tag, first->place.line));
        first = &child;
    }
}

bool is_referred_into(const XmlElement& element, const Loader& loader) {
    const auto id = element.attributes.find("id");
    return (id != element.attributes.end() && loader.referred.contains(id->second)) ||
           std::ranges::any_of(element.children, [&](const auto& child) { return is_referred_into(child, loader); });
}

// What stands at the root for others to refer to, and is referred to by none.
void report_unreferred(const XmlElement& root, Loader& loader) {
    for (const XmlElement& child : root.children) {
        if (child.tag != "bsdf" && child.tag != "texture") continue;
        const std::string what = fmt::format("{} '{}'", child.tag, child.attribute("type"));
        const std::string id = child.has("id") ? child.attribute("id") : "";
        if (loader.referred.contains(id)) continue;
        if (is_referred_into(child, loader))
            loader.ignored(child.place, fmt::format("{}: a <ref> leads to what is within, none to it", what));
        else if (!id.empty())
            loader.ignored(child.place, fmt::format("{}: no <ref> to '{}'", what, id));
        else
            loader.replaced(
                child.place, fmt::format("{} by its absence", what),
                child.place.error(fmt::format("{} at the root without an id, so that nothing can refer to it; "
                                              "an id, or a place within what uses it, is accepted",
                                              what)));
    }
}

void report_unused_names(const std::vector<XmlElement>& unused, Loader& loader) {
    for (const XmlElement& element : unused)
        loader.ignored(element.place,
                       fmt::format("the default of ${}, for which nothing asks", element.attribute("name")));
}

void append_text(const XmlElement& element, std::string& text) {
    text += '<' + element.tag;
    for (const auto& [name, value] : element.attributes) text += ' ' + name + '=' + value;
    for (const XmlElement& child : element.children) append_text(child, text);
    text += '>';
}

// The hash of the content: where the files lie does not matter, only what is in them.
std::uint64_t content_hash(const XmlElement& root, const Loader& loader) {
    std::string text;
    append_text(root, text);
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
    mitsuba::index_ids(root, loader);
    mitsuba::index_aliases(root, loader);
    mitsuba::accept_one(root, "integrator");
    mitsuba::load_elements(root, loader);
    mitsuba::report_unreferred(root, loader);
    mitsuba::report_unused_names(tree.unused_names, loader);
    if (!loader.scene.sensor) loader.scene.sensor = mitsuba::default_sensor(root, loader);
    loader.scene.content_hash = mitsuba::content_hash(root, loader);
    return std::move(loader.scene);
}

}  // namespace plumb
