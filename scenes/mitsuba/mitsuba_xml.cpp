#include "scenes/mitsuba/mitsuba_xml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/file.h"
#include "core/random.h"
#include "scenes/mitsuba/loader.h"
#include "scenes/mitsuba/plugins.h"

namespace plumb {

namespace mitsuba {

const XmlElement& Loader::resolve(const XmlElement& element) const {
    const XmlElement* target = &element;
    for (std::size_t hops = 0; target->tag == "ref"; ++hops) {
        const std::string& id = target->attribute("id");
        const auto found = named.find(id);
        if (found == named.end()) throw element.place.error(fmt::format("<ref> to '{}', but nothing has this id", id));
        if (hops > named.size()) throw element.place.error(fmt::format("<ref> to '{}' goes round in a circle", id));
        target = found->second;
        target->reading.referred = true;
    }
    return *target;
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
        // Whether an id is accepted is up to whoever reads the element.
        if (const auto id = child.attributes.find("id"); id != child.attributes.end() && child.tag != "ref") {
            const auto [found, is_new] = loader.named.try_emplace(id->second, &child);
            if (!is_new)
                throw child.place.error(
                    fmt::format("the id '{}' is taken by line {}", id->second, found->second->place.line));
        }
        index_ids(child, loader);
    }
}

void load_element(const XmlElement& element, Loader& loader) {
    description::Scene& scene = loader.scene;
    element.reading.taken = true;
    if (element.tag == "shape") {
        scene.shapes.push_back(load_shape(element, loader));
    } else if (element.tag == "bsdf") {
        load_material(element, loader);
    } else if (element.tag == "texture") {
        load_texture(element, loader);
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
    } else if (element.tag == "default") {
        element.reading.passed_over = true;
        loader.ignored(element.place,
                       fmt::format("the default of ${}, for which nothing asks", element.attribute("name")));
    } else {
        throw element.place.error(
            unknown_name("element", element.tag,
                         {"bsdf", "default", "emitter", "include", "integrator", "sensor", "shape", "texture"})
                .what());
    }
}

void accept_one(const XmlElement& root, const std::string& tag) {
    const XmlElement* first = nullptr;
    for (const XmlElement& child : root.children) {
        if (child.tag != tag) continue;
        if (first) throw child.place.error(fmt::format("a second {}; the first is in line {}", tag, first->place.line));
        first = &child;
    }
}

// What stands at the root for others to refer to, and is referred to by none.
void report_unreferred(const XmlElement& root, Loader& loader) {
    for (const XmlElement& child : root.children) {
        if ((child.tag != "bsdf" && child.tag != "texture") || child.reading.referred) continue;
        const std::string what = fmt::format("{} '{}'", child.tag, child.attribute("type"));
        if (child.has("id"))
            loader.ignored(child.place, fmt::format("{}: no <ref> to '{}'", what, child.attribute("id")));
        else
            loader.replaced(
                child.place, fmt::format("{} by its absence", what),
                child.place.error(fmt::format("{} at the root without an id, so that nothing can refer to it; "
                                              "an id, or a place within what uses it, is accepted",
                                              what)));
    }
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
    const XmlElement root = read_xml_tree(file, options.definitions);
    mitsuba::Loader loader{.options = options, .folder = file.parent_path()};
    mitsuba::index_ids(root, loader);
    mitsuba::accept_one(root, "integrator");
    for (const XmlElement& element : root.children) mitsuba::load_element(element, loader);
    mitsuba::report_unread(root, loader);
    mitsuba::report_unreferred(root, loader);
    if (!loader.scene.sensor) loader.scene.sensor = mitsuba::default_sensor(root, loader);
    loader.scene.content_hash = mitsuba::content_hash(root, loader);
    return std::move(loader.scene);
}

}  // namespace plumb
