#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/srgb.h"
#include "scenes/mitsuba/loader.h"
#include "scenes/spectra/metals.h"
#include "scenes/spectra/tabulated_spectrum.h"

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

std::vector<double> parse_numbers(const std::string& text, const Place& place) {
    std::vector<double> numbers;
    for (std::size_t at = 0; (at = text.find_first_not_of(" ,\t\n\r", at)) != std::string::npos;) {
        const std::size_t end = std::min(text.size(), text.find_first_of(" ,\t\n\r", at));
        numbers.push_back(parse_number(text.substr(at, end - at), place));
        at = end;
    }
    return numbers;
}

Vec3 parse_triple(const std::string& text, const Place& place) {
    const std::vector<double> v = parse_numbers(text, place);
    if (v.size() != 3) throw place.error(fmt::format("'{}' where three numbers are expected", text));
    return {v[0], v[1], v[2]};
}

TabulatedSpectrum parse_table(const std::string& text, const Place& place) {
    TabulatedSpectrum table;
    for (std::size_t at = 0; (at = text.find_first_not_of(" ,\t\n\r", at)) != std::string::npos;) {
        const std::size_t end = std::min(text.size(), text.find(',', at)), colon = text.find(':', at);
        if (colon >= end) throw place.error(fmt::format("'{}' where nm:value is expected", text.substr(at, end - at)));
        table.emplace_back(parse_number(text.substr(at, colon - at), place),
                           parse_number(text.substr(colon + 1, end - colon - 1), place));
        if (table.size() > 1 && !(table.back().first > table[table.size() - 2].first)) {
            throw place.error(fmt::format("wavelength {} after {}; ascending ones are accepted", table.back().first,
                                          table[table.size() - 2].first));
        }
        at = end;
    }
    return table;
}

Spectrum parse_hex(const std::string& text, const Place& place) {
    unsigned value = 0;
    const auto [end, code] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
    if (text.size() != 7 || code != std::errc{} || end != text.data() + 7) {
        throw place.error(fmt::format("'{}' where #rrggbb is expected", text));
    }
    const auto linear = [](unsigned byte) { return linear_from_srgb(byte / 255.0); };
    return Spectrum::rgb(linear(value >> 16), linear(value >> 8 & 255), linear(value & 255));
}

Transform parse_step(const XmlElement& step) {
    if (step.tag == "translate") return Transform::translate(parse_vector(step, {0, 0, 0}));
    if (step.tag == "scale") return Transform::scale(parse_vector(step, {1, 1, 1}));
    if (step.tag == "rotate") {
        return Transform::rotate(parse_vector(step, {0, 0, 0}), parse_number(step.attribute("angle"), step.place));
    }
    if (step.tag == "lookat" || step.tag == "lookAt") {
        const auto triple = [&](const char* name) { return parse_triple(step.attribute(name), step.place); };
        return Transform::look_at(triple("origin"), triple("target"), triple("up"));
    }
    if (step.tag == "matrix") {
        const std::vector<double> m = parse_numbers(step.attribute("value"), step.place);
        Transform::Matrix matrix{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
        if (m.size() != 16 && m.size() != 9) {
            throw step.place.error(fmt::format("a matrix of {} numbers; 16 or 9 are accepted", m.size()));
        }
        const std::size_t side = m.size() == 16 ? 4 : 3;
        for (std::size_t i = 0; i < m.size(); ++i) matrix[i / side][i % side] = m[i];
        return Transform(matrix);
    }
    throw step.place.error(
        fmt::format("unknown <{}> in a transform; translate, scale, rotate, lookat and matrix are accepted", step.tag));
}

}  // namespace

Vec3 parse_vector(const XmlElement& element, Vec3 otherwise) {
    if (element.has("value")) {
        const std::vector<double> v = parse_numbers(element.attribute("value"), element.place);
        if (v.size() == 1) return {v[0], v[0], v[0]};
        return parse_triple(element.attribute("value"), element.place);
    }
    const auto axis = [&](const char* name, double missing) {
        return element.has(name) ? parse_number(element.attribute(name), element.place) : missing;
    };
    return {axis("x", otherwise.x), axis("y", otherwise.y), axis("z", otherwise.z)};
}

Spectrum parse_spectrum(const XmlElement& element, bool emission) {
    const std::string& text = element.attribute("value");
    if (text.starts_with('#')) return parse_hex(text, element.place);
    if (text.find(':') != std::string::npos) {
        const TabulatedSpectrum table = parse_table(text, element.place);
        return emission ? emission_rgb(table) : reflectance_rgb(table);
    }
    const std::vector<double> v = parse_numbers(text, element.place);
    if (v.size() == 1) return Spectrum::grey(v[0]);
    if (v.size() == 3) return Spectrum::rgb(v[0], v[1], v[2]);
    throw element.place.error(
        fmt::format("'{}' where one number, three, #rrggbb or nm:value pairs are expected", text));
}

Transform parse_transform(const XmlElement& element) {
    Transform result;
    for (const XmlElement& step : element.children) {
        try {
            result = parse_step(step) * result;
        } catch (const Error& error) {
            const std::string message = error.what();
            if (message.starts_with(step.place.file + ":")) throw;
            throw step.place.error(message);
        }
    }
    return result;
}

XmlProperties::XmlProperties(const XmlElement& element, Loader& loader) : element_(element), loader_(loader) {
    for (const XmlElement& child : element.children) {
        if (!child.has("name")) continue;
        const std::string name = snake_case(child.attribute("name"));
        if (!values_.try_emplace(name, &child).second)
            throw child.place.error(fmt::format("'{}' is given twice", name));
    }
}

const Place& XmlProperties::place_of(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? element_.place : found->second->place;
}

const XmlElement* XmlProperties::take(const std::string& name) {
    known_.insert(name);
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : found->second;
}

double XmlProperties::number(const std::string& name, double otherwise) {
    const XmlElement* value = take(name);
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
    const XmlElement* value = take(name);
    if (!value) return otherwise;
    const std::string text = snake_case(value->attribute("value"));
    if (text != "true" && text != "false") {
        throw value->place.error(fmt::format("{} is '{}'; true or false are accepted", name, text));
    }
    return text == "true";
}

std::string XmlProperties::string(const std::string& name, const std::string& otherwise) {
    const XmlElement* value = take(name);
    return value ? value->attribute("value") : otherwise;
}

std::filesystem::path XmlProperties::file(const std::string& name) {
    const XmlElement* value = take(name);
    if (!value) throw element_.place.error(fmt::format("<{}> without a '{}'", element_.tag, name));
    const std::filesystem::path path =
        std::filesystem::path(value->place.file).parent_path() / value->attribute("value");
    if (!std::filesystem::is_regular_file(path))
        throw value->place.error(fmt::format("there is no file {}", path.string()));
    loader_.files.insert(path);
    return path;
}

Vec3 XmlProperties::vector(const std::string& name, Vec3 otherwise) {
    const XmlElement* value = take(name);
    return value ? parse_vector(*value, otherwise) : otherwise;
}

Spectrum XmlProperties::constant(const std::string& name, const Spectrum& otherwise, bool emission, double most) {
    const XmlElement* value = take(name);
    if (!value) return otherwise;
    if (value->tag == "texture" || value->tag == "ref") {
        throw value->place.error(fmt::format("{} is a {}; a constant is accepted", name, value->tag));
    }
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
    const XmlElement* value = take(name);
    if (!value) return otherwise;
    if (value->tag == "texture" || value->tag == "ref") return load_texture(loader_.resolve(*value), loader_);
    return constant_reflectance(name, otherwise);
}

Transform XmlProperties::transform(const std::string& name) {
    const XmlElement* value = take(name);
    return value ? parse_transform(*value) : Transform();
}

double XmlProperties::index(const std::string& name, const std::string& otherwise) {
    const XmlElement* value = take(name);
    if (!value) return named_index(otherwise);
    double result = 0;
    if (value->tag != "string") {
        result = parse_number(value->attribute("value"), value->place);
    } else {
        try {
            result = named_index(value->attribute("value"));
        } catch (const Error& error) {
            throw value->place.error(error.what());
        }
    }
    if (!(result > 0)) throw value->place.error(fmt::format("{} is {}; indices above 0 are accepted", name, result));
    return result;
}

// The <bsdf> children, refs followed.
std::vector<MaterialId> XmlProperties::nested_materials(std::size_t most) {
    std::vector<MaterialId> nested;
    for (const XmlElement& child : element_.children) {
        if (child.tag == "ref" && loader_.resolve(child).tag != "bsdf") continue;
        if (child.tag == "bsdf" || child.tag == "ref") nested.push_back(load_material(loader_.resolve(child), loader_));
    }
    if (nested.empty() || nested.size() > most) {
        throw element_.place.error(fmt::format("'{}' around {} bsdfs; 1{} is accepted", element_.attribute("type"),
                                               nested.size(), most == 2 ? " or 2" : ""));
    }
    return nested;
}

void XmlProperties::finish(bool advisory) {
    for (const auto& [name, value] : values_) {
        if (known_.contains(name) || value->tag == "bsdf" || value->tag == "emitter" || value->tag == "rfilter" ||
            value->tag == "film" || value->tag == "sampler") {
            continue;
        }
        const std::string type = element_.has("type") ? element_.attribute("type") : element_.tag;
        if (advisory) {
            loader_.ignored(value->place, fmt::format("'{}' of {}", name, type));
        } else {
            loader_.replaced(
                value->place, fmt::format("'{}' of {} by its absence", name, type),
                value->place.error(
                    unknown_name(fmt::format("property of {}", type), name, {known_.begin(), known_.end()}).what()));
        }
    }
}

}  // namespace plumb::mitsuba
