#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenes/mitsuba/loader.h"
#include "scenes/spectra/metals.h"

namespace plumb::mitsuba {

using description::Colour;
using description::MaterialId;
using description::parse_number;
using description::Place;

std::string snake_case(const std::string& name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        // A capital opens a word after a small letter: intIOR is int_ior, toUV is to_uv.
        if (std::isupper(c) && i > 0 && !std::isupper(static_cast<unsigned char>(name[i - 1])) && name[i - 1] != '_')
            result += '_';
        result += static_cast<char>(std::tolower(c));
    }
    return result;
}

namespace {

const Form number_form{{"float", "integer"}, "a number (<float>, <integer>)"};
const Form boolean_form{{"boolean"}, "<boolean>"};
const Form string_form{{"string"}, "<string>"};
const Form vector_form{{"point", "vector"}, "<point> or <vector>"};
const Form transform_form{{"transform"}, "<transform>"};
const Form index_form{{"float", "integer", "string"}, "a number (<float>) or a medium's name (<string>)"};
const Form spectrum_form{{"rgb", "srgb", "spectrum", "float", "integer"},
                         "a constant (<rgb>, <spectrum>, <float>: one number, three, #rrggbb or nm:value pairs)"};
const Form reflectance_form{{"rgb", "srgb", "spectrum", "float", "integer", "texture", "ref"},
                            "a <texture>, a <ref> to one or a constant (<rgb>, <spectrum>, <float>: one number, three, "
                            "#rrggbb or nm:value pairs)"};

}  // namespace

XmlProperties::XmlProperties(const XmlElement& element, Loader& loader) : element_(element), loader_(loader) {
    for (const char* attribute : {"type", "id", "name"}) element.reading.attributes.insert(attribute);
    for (const XmlElement& child : element.children) {
        if (!is_known_tag(child.tag) || !child.has("name")) continue;
        const std::string name = snake_case(child.attribute("name"));
        if (!values_.try_emplace(name, &child).second)
            throw child.place.error(fmt::format("'{}' is given twice", name));
    }
}

const Place& XmlProperties::place_of(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? element_.place : found->second->place;
}

void XmlProperties::assume(const std::string& name, const std::string& value) {
    assumed_.push_back(
        {.tag = "string", .attributes = {{"name", name}, {"value", value}}, .children = {}, .place = element_.place});
    values_.try_emplace(name, &assumed_.back());
}

const XmlElement* XmlProperties::take(const std::string& name, const Form& form) {
    element_.reading.names.insert(name);
    const auto found = values_.find(name);
    if (found == values_.end()) return nullptr;
    const XmlElement& value = *found->second;
    value.reading.taken = true;
    if (std::ranges::find(form.tags, value.tag) == form.tags.end())
        throw value.place.error(fmt::format("{} is a <{}>; accepted is {}", name, value.tag, form.text));
    return &value;
}

Error XmlProperties::lacks(const std::string& name) const {
    std::vector<std::string> given;
    for (const auto& [other, value] : values_) given.push_back(fmt::format("'{}'", other));
    return element_.place.error(fmt::format("<{}> without a '{}'{}{}", element_.tag, name,
                                            given.empty() ? "" : "; it has ", fmt::join(given, ", ")));
}

double XmlProperties::number(const std::string& name, double otherwise) {
    const XmlElement* value = take(name, number_form);
    return value ? parse_number(value->attribute("value"), value->place) : otherwise;
}

int XmlProperties::integer(const std::string& name, int otherwise) {
    const double value = number(name, otherwise);
    if (value != std::floor(value) || std::abs(value) > 1e9) {
        throw values_.at(name)->place.error(fmt::format("{} is {}; a whole number is accepted", name, value));
    }
    return static_cast<int>(value);
}

bool XmlProperties::boolean(const std::string& name, bool otherwise) {
    const XmlElement* value = take(name, boolean_form);
    if (!value) return otherwise;
    const std::string text = snake_case(value->attribute("value"));
    if (text != "true" && text != "false") {
        throw value->place.error(fmt::format("{} is '{}'; true or false are accepted", name, text));
    }
    return text == "true";
}

std::string XmlProperties::string(const std::string& name, const std::string& otherwise) {
    const XmlElement* value = take(name, string_form);
    return value ? value->attribute("value") : otherwise;
}

std::filesystem::path XmlProperties::file(const std::string& name) {
    const XmlElement* value = take(name, string_form);
    if (!value) throw lacks(name);
    const std::filesystem::path path = find_file(value->attribute("value"), value->place, loader_.folders);
    loader_.files.insert(path);
    return path;
}

Vec3 XmlProperties::vector(const std::string& name, Vec3 otherwise) {
    const XmlElement* value = take(name, vector_form);
    return value ? parse_vector(*value, otherwise) : otherwise;
}

Spectrum XmlProperties::constant(const std::string& name, const Spectrum& otherwise, bool emission, double most) {
    const XmlElement* value = take(name, spectrum_form);
    if (!value) return otherwise;
    // How 0.6 makes a spectrum of three numbers, which it does not when it renders three numbers.
    if ((value->tag == "rgb" || value->tag == "srgb") && value->has("intent"))
        loader_.ignored(value->place, fmt::format("the intent of {}", name));
    const Spectrum result = parse_spectrum(*value, emission);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(result[i] >= 0 && result[i] <= most)) {
            throw value->place.error(fmt::format("{} is {}; values from 0{} are accepted", name, result[i],
                                                 std::isfinite(most) ? fmt::format(" to {}", most) : ""));
        }
    }
    return result;
}

Spectrum XmlProperties::spectrum(const std::string& name, const Spectrum& otherwise) {
    return constant(name, otherwise, false, HUGE_VAL);
}

Spectrum XmlProperties::emission(const std::string& name, const Spectrum& otherwise) {
    return constant(name, otherwise, true, HUGE_VAL);
}

Spectrum XmlProperties::constant_reflectance(const std::string& name, const Spectrum& otherwise) {
    return constant(name, otherwise, false, 1);
}

Colour XmlProperties::reflectance(const std::string& name, const Spectrum& otherwise) {
    const XmlElement* value = take(name, reflectance_form);
    if (!value) return otherwise;
    if (value->tag == "texture" || value->tag == "ref") return load_texture(loader_.resolve(*value), loader_);
    return constant_reflectance(name, otherwise);
}

Transform XmlProperties::transform(const std::string& name) {
    const XmlElement* value = take(name, transform_form);
    return value ? parse_transform(*value, name == "to_uv") : Transform();
}

double XmlProperties::index(const std::string& name, const std::string& otherwise) {
    const XmlElement* value = take(name, index_form);
    if (!value) return named_index(otherwise);
    double result = 0;
    if (value->tag != "string") {
        result = parse_number(value->attribute("value"), value->place);
    } else {
        try {
            result = named_index(description::lower_case(value->attribute("value")));
        } catch (const Error& error) {
            throw value->place.error(error.what());
        }
    }
    if (!(result > 0)) throw value->place.error(fmt::format("{} is {}; indices above 0 are accepted", name, result));
    return result;
}

std::vector<const XmlElement*> XmlProperties::parts(const std::string& tag) {
    element_.reading.parts.insert(tag);
    std::vector<const XmlElement*> found;
    for (const XmlElement& child : element_.children) {
        const XmlElement& target = child.tag == "ref" ? loader_.resolve(child) : child;
        if (target.tag != tag) continue;
        child.reading.taken = target.reading.taken = true;
        found.push_back(&target);
    }
    return found;
}

const XmlElement* XmlProperties::part(const std::string& tag) {
    const std::vector<const XmlElement*> found = parts(tag);
    if (found.size() > 1)
        throw element_.place.error(fmt::format("{} {} elements in {}; one is accepted (lines {} and {})", found.size(),
                                               tag, element_.attribute("type"), found[0]->place.line,
                                               found[1]->place.line));
    return found.empty() ? nullptr : found.front();
}

std::vector<MaterialId> XmlProperties::nested_materials(std::size_t most) {
    std::vector<MaterialId> nested;
    for (const XmlElement* part : parts("bsdf")) nested.push_back(load_material(*part, loader_));
    if (nested.empty() || nested.size() > most) {
        throw element_.place.error(fmt::format("'{}' around {} bsdfs; 1{} is accepted", element_.attribute("type"),
                                               nested.size(), most == 2 ? " or 2" : ""));
    }
    return nested;
}

void XmlProperties::pass_over(const std::string& name) {
    element_.reading.names.insert(name);
    const auto found = values_.find(name);
    if (found == values_.end()) return;
    found->second->reading.taken = true;
    static_cast<void>(found->second->attribute("value"));
}

void XmlProperties::finish() {
    for (const std::string& name : names_without_effect(element_.tag)) {
        const auto found = values_.find(name);
        if (found == values_.end() || found->second->reading.taken) continue;
        pass_over(name);
        loader_.ignored(found->second->place, fmt::format("'{}' of {}", name, type()));
    }
    report_unread(element_, loader_);
}

}  // namespace plumb::mitsuba
