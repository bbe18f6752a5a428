#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

namespace {

const std::vector<std::string> values{"blackbody", "boolean", "float",  "integer", "point",     "rgb",
                                      "spectrum",  "srgb",    "string", "texture", "transform", "vector"};
const std::vector<std::string> things{"bsdf",    "emitter", "film",   "integrator", "medium",     "phase",   "ref",
                                      "rfilter", "sampler", "sensor", "shape",      "subsurface", "texture", "volume"};

const std::vector<std::string> steps{"lookAt", "lookat", "matrix", "rotate", "scale", "translate"};
const std::vector<std::string> said_to_the_reader{"alias", "default", "include", "path", "scene"};

bool is_in(const std::vector<std::string>& list, const std::string& tag) {
    return std::ranges::find(list, tag) != list.end();
}

std::string label(const XmlElement& element) {
    const auto type = element.attributes.find("type");
    return type == element.attributes.end() ? fmt::format("<{}>", element.tag) : type->second;
}

/// What may stand within the element, in words.
std::string accepted(const XmlElement& element) {
    std::vector<std::string> said;
    if (const auto& names = element.reading.names; !names.empty())
        said.push_back(fmt::format("values by the names {}", fmt::join(names, ", ")));
    for (const std::string& part : element.reading.parts) said.push_back(fmt::format("<{}>", part));
    return said.empty() ? "nothing is accepted there" : fmt::format("accepted are {}", fmt::join(said, " and "));
}

std::string unknown_value(const std::string& name, const XmlElement& parent) {
    const auto& asked = parent.reading.names;
    const std::string typed = snake_case(name);
    std::vector<std::string> known(asked.begin(), asked.end());
    const std::string what = fmt::format("property of {}", label(parent));
    // What has no effect may be meant, but is not offered.
    std::vector<std::string> meant = known;
    std::ranges::copy(names_without_effect(parent.tag), std::back_inserter(meant));
    if (!nearest_name(typed, meant).empty()) return unknown_name(what, typed, meant).what();
    if (known.empty()) return fmt::format("'{}' within {}; {}", name, label(parent), accepted(parent));
    return unknown_name(what, typed, known).what();
}

/// The mistake that a child is which nobody read.
std::string mistake(const XmlElement& child, const XmlElement& parent) {
    const std::string within = label(parent);
    const auto name = child.attributes.find("name");
    if (is_value(child.tag))
        return name != child.attributes.end()
                   ? unknown_value(name->second, parent)
                   : fmt::format("<{}> without a name within {}; {}", child.tag, within, accepted(parent));
    const std::string target = child.tag == "ref" ? fmt::format(" to '{}'", child.attribute("id")) : "";
    return fmt::format("<{}>{} within {}, where nothing takes it; {}", child.tag, target, within, accepted(parent));
}

void report_attributes(const XmlElement& element, Loader& loader) {
    for (const auto& [name, value] : element.attributes) {
        const auto& asked = element.reading.attributes;
        if (asked.contains(name)) continue;
        const std::vector<std::string> known(asked.begin(), asked.end());
        const std::string what = fmt::format("attribute of <{}>", element.tag);
        loader.replaced(element.place, fmt::format("the attribute '{}' of <{}> by its absence", name, element.tag),
                        element.place.error(known.empty() ? fmt::format("unknown {} '{}'; none is accepted", what, name)
                                                          : unknown_name(what, name, known).what()));
    }
    for (const auto& [name, value] : element.attributes) element.reading.attributes.insert(name);
}

/// Notes the absence of a child where the user is lenient, else throws the error.
void leave_out(const XmlElement& child, const XmlElement& parent, const std::string& error, Loader& loader) {
    const auto name = child.attributes.find("name");
    const std::string what =
        name == child.attributes.end() ? fmt::format("<{}>", child.tag) : fmt::format("'{}'", snake_case(name->second));
    loader.replaced(child.place, fmt::format("{} of {} by its absence", what, label(parent)), child.place.error(error));
    child.reading.taken = child.reading.left_out = true;
}

}  // namespace

bool is_value(const std::string& tag) {
    return is_in(values, tag);
}

bool is_known_tag(const std::string& tag) {
    return is_in(values, tag) || is_in(things, tag) || is_in(steps, tag) || is_in(said_to_the_reader, tag);
}

void report_unknown_tags(const XmlElement& element, Loader& loader) {
    for (const XmlElement& child : element.children) {
        report_unknown_tags(child, loader);
        if (is_known_tag(child.tag)) continue;
        std::vector<std::string> tags = element.tag == "transform" ? steps : things;
        if (element.tag != "transform") tags.insert(tags.end(), values.begin(), values.end());
        const std::string near = nearest_name(child.tag, tags);
        leave_out(child, element,
                  fmt::format("unknown element <{}> within {}; {}", child.tag, label(element),
                              near.empty() ? fmt::format("accepted are <{}>", fmt::join(tags, ">, <"))
                                           : fmt::format("did you mean <{}>?", near)),
                  loader);
    }
}

void report_unread(const XmlElement& element, Loader& loader) {
    if (element.reading.left_out) return;
    report_attributes(element, loader);
    for (const XmlElement& child : element.children) {
        if (child.reading.taken) {
            report_unread(child, loader);
            continue;
        }
        leave_out(child, element, mistake(child, element), loader);
    }
}

const std::vector<std::string>& names_without_effect(const std::string& tag) {
    static const std::map<std::string, std::vector<std::string>> names{
        {"bsdf", {"sample_visible", "specular_sampling_weight"}},
        {"emitter", {"cache", "mis_compensation", "sampling_weight"}},
        {"film",
         {"attach_log", "banner", "burn", "compensate", "component_format", "exposure", "file_format", "gamma",
          "high_quality_edges", "key", "pixel_format", "sample_border", "tonemap_method"}},
        {"integrator",
         {"bsdf_samples", "emitter_samples", "hide_emitters", "luminaire_samples", "shading_samples",
          "strict_normals"}},
        {"sampler", {"dimension", "jitter", "sample_count", "scramble", "seed", "strength"}},
        {"shape", {"collapse", "max_smooth_angle"}},
        {"sensor", {"far_clip", "focus_distance", "near_clip", "shutter_close", "shutter_open"}},
        {"texture", {"accel", "cache", "max_anisotropy"}}};
    static const std::vector<std::string> none;
    const auto found = names.find(tag);
    return found == names.end() ? none : found->second;
}

}  // namespace plumb::mitsuba
