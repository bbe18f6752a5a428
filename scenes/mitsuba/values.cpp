#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/srgb.h"
#include "scenes/mitsuba/loader.h"
#include "scenes/spectra/tabulated_spectrum.h"

namespace plumb::mitsuba {

using description::parse_number;
using description::Place;

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
    const std::string blanks = " \t\n\r", separators = " ,\t\n\r";
    for (std::size_t at = 0; (at = text.find_first_not_of(separators, at)) != std::string::npos;) {
        // Blanks separate pairs, as commas do, unless they stand beside the colon.
        const std::size_t colon = text.find(':', at), digits = text.find_first_not_of(blanks, colon + 1);
        const std::size_t first_end = std::min(text.size(), text.find_first_of(separators + ':', at));
        const std::size_t end = colon == std::string::npos || text.find_first_not_of(blanks, first_end) != colon
                                    ? first_end
                                    : std::min(text.size(), text.find_first_of(separators, digits));
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

// Without an `up`, or with one of 0 0 0, Mitsuba takes the first axis beside the direction of view.
Transform parse_look_at(const XmlElement& step) {
    const auto triple = [&](const char* name) { return parse_triple(step.attribute(name), step.place); };
    const Vec3 origin = triple("origin"), target = triple("target"), up = step.has("up") ? triple("up") : Vec3{};
    const Vec3 to_target = target - origin;
    const bool any = length_squared(up) == 0 && length_squared(to_target) > 0;
    return Transform::look_at(origin, target, any ? Frame(normalize(to_target)).x : up);
}

Transform parse_matrix(const XmlElement& step, bool of_texture) {
    const std::vector<double> m = parse_numbers(step.attribute("value"), step.place);
    Transform::Matrix matrix{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    if (m.size() != 16 && m.size() != 9)
        throw step.place.error(fmt::format("a matrix of {} numbers; 16 or 9 are accepted", m.size()));
    const std::size_t side = m.size() == 16 ? 4 : 3;
    // In the plane the third row and column of nine numbers are the fourth of sixteen.
    const auto place = [&](std::size_t i) { return of_texture && side == 3 && i == 2 ? 3 : i; };
    for (std::size_t i = 0; i < m.size(); ++i) matrix[place(i / side)][place(i % side)] = m[i];
    return Transform(matrix);
}

Transform parse_step(const XmlElement& step, bool of_texture) {
    step.reading.taken = true;
    if (step.tag == "translate") return Transform::translate(parse_vector(step, {0, 0, 0}));
    if (step.tag == "scale") return Transform::scale(parse_vector(step, {1, 1, 1}));
    if (step.tag == "rotate") {
        return Transform::rotate(parse_vector(step, {0, 0, 0}), parse_number(step.attribute("angle"), step.place));
    }
    if (step.tag == "lookat" || step.tag == "lookAt") return parse_look_at(step);
    if (step.tag == "matrix") return parse_matrix(step, of_texture);
    throw step.place.error(
        fmt::format("unknown <{}> in a transform; translate, scale, rotate, lookat and matrix are accepted", step.tag));
}

}  // namespace

Vec3 parse_vector(const XmlElement& element, Vec3 otherwise) {
    const std::array axes{"x", "y", "z"};
    if (element.has("value")) {
        for (const char* name : axes)
            if (element.has(name))
                throw element.place.error(
                    fmt::format("value and {} of <{}> are given; one way is accepted", name, element.tag));
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
    const bool has_file = element.tag == "spectrum" && element.has("filename");
    const bool has_plugin = element.tag == "spectrum" && element.has("type");
    if (has_file || has_plugin)
        throw element.place.error(
            fmt::format("a spectrum {}; one number, three, #rrggbb or nm:value pairs are accepted",
                        has_file ? "from a file" : fmt::format("of type '{}'", element.attribute("type"))));
    const std::string& text = element.attribute("value");
    if (text.starts_with('#')) return parse_hex(text, element.place);
    if (text.find(':') != std::string::npos) {
        const TabulatedSpectrum table = parse_table(text, element.place);
        return emission ? emission_rgb(table) : reflectance_rgb(table);
    }
    const std::vector<double> v = parse_numbers(text, element.place);
    const auto linear = [&](double x) { return element.tag == "srgb" ? linear_from_srgb(x) : x; };
    if (v.size() == 1) return Spectrum::grey(linear(v[0]));
    if (v.size() == 3) return Spectrum::rgb(linear(v[0]), linear(v[1]), linear(v[2]));
    throw element.place.error(
        fmt::format("'{}' where one number, three, #rrggbb or nm:value pairs are expected", text));
}

Transform parse_transform(const XmlElement& element, bool of_texture) {
    Transform result;
    for (const XmlElement& step : element.children) {
        try {
            result = parse_step(step, of_texture) * result;
        } catch (const Error& error) {
            const std::string message = error.what();
            if (message.starts_with(step.place.file + ":")) throw;
            throw step.place.error(message);
        }
    }
    const auto& m = result.matrix();
    if (of_texture && (m[0][2] != 0 || m[1][2] != 0)) {
        throw element.place.error(
            fmt::format("a texture's transform with the third column {} {}, which no texture coordinate meets; 0 0 is "
                        "accepted, and a shift in the fourth column",
                        m[0][2], m[1][2]));
    }
    return result;
}

}  // namespace plumb::mitsuba
