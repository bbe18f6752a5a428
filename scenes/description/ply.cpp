#include "scenes/description/ply.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "core/file.h"
#include "scenes/description/polygon.h"
#include "scenes/description/text_cursor.h"

namespace plumb {

namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
    std::string name;
    Type type = Type::f32;
    std::optional<Type> count_type;  ///< of a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Format { ascii, little_endian, big_endian };

struct Header {
    Format format = Format::ascii;
    std::vector<Element> elements;
};

Type read_type(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    static constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                           {"uchar", "uint8"},
                                                                           {"short", "int16"},
                                                                           {"ushort", "uint16"},
                                                                           {"int", "int32"},
                                                                           {"uint", "uint32"},
                                                                           {"float", "float32"},
                                                                           {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (word == names[i][0] || word == names[i][1]) return static_cast<Type>(i);
    }
    throw cursor.error(fmt::format("unknown PLY type '{}'", word));
}

Format read_format(TextCursor& cursor) {
    const std::string_view word = cursor.word();
    if (word == "ascii") return Format::ascii;
    if (word == "binary_little_endian") return Format::little_endian;
    if (word == "binary_big_endian") return Format::big_endian;
    throw cursor.error(fmt::format("unknown PLY format '{}'", word));
}

Header read_header(TextCursor& cursor) {
    if (cursor.word() != "ply") throw cursor.error("not a PLY file: its first line is not 'ply'");
    Header header;
    bool has_format = false;
    for (cursor.next_line();; cursor.next_line()) {
        if (cursor.at_end()) throw cursor.error("truncated: no end_header");
        const std::string_view keyword = cursor.word();
        if (keyword == "end_header") break;
        if (keyword == "format") {
            header.format = read_format(cursor);
            has_format = true;
        } else if (keyword == "element") {
            Element element{.name = std::string(cursor.word()), .count = 0, .properties = {}};
            element.count = cursor.number<std::uint64_t>("the element's count");
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            if (header.elements.empty()) throw cursor.error("a property before any element");
            Property property;
            TextCursor ahead = cursor;
            if (ahead.word() == "list") {
                cursor.word();
                property.count_type = read_type(cursor);
            }
            property.type = read_type(cursor);
            property.name = cursor.word();
            header.elements.back().properties.push_back(std::move(property));
        }
    }
    if (!has_format) throw cursor.error("PLY header without a format");
    cursor.next_line();
    return header;
}

/// The body's values one after the other, as doubles (exact for every type of PLY).
class Values {
public:
    Values(std::string_view text, const std::string& file, TextCursor cursor, Format format)
        : text_(text), file_(file), cursor_(std::move(cursor)), format_(format), at_(cursor_.offset()) {}

    void start(const Element& element, std::uint64_t index) {
        element_ = &element;
        index_ = index;
        if (format_ != Format::ascii) return;
        while (!cursor_.at_end() && cursor_.line_done()) cursor_.next_line();
        if (cursor_.at_end()) throw error(fmt::format("truncated: {} of {}", index, element.count));
    }
    void finish() {
        if (format_ == Format::ascii) cursor_.next_line();
    }

    double next(Type type, const std::string& name) {
        if (format_ == Format::ascii) return cursor_.number<double>(name);
        switch (type) {
            case Type::i8: return raw<std::int8_t>();
            case Type::u8: return raw<std::uint8_t>();
            case Type::i16: return raw<std::int16_t>();
            case Type::u16: return raw<std::uint16_t>();
            case Type::i32: return raw<std::int32_t>();
            case Type::u32: return raw<std::uint32_t>();
            case Type::f32: return raw<float>();
            case Type::f64: return raw<double>();
        }
        throw error("a property of an unknown type");
    }

    [[nodiscard]] Error error(const std::string& message) const {
        const std::string text = fmt::format("{} {}: {}", element_->name, index_, message);
        return format_ == Format::ascii ? cursor_.error(text) : Error(file_ + ": " + text);
    }

private:
    template <class T>
    double raw() {
        if (text_.size() - at_ < sizeof(T))
            throw error(fmt::format("truncated: the file ends after {} of {}", index_, element_->count));
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), text_.data() + at_, sizeof(T));
        at_ += sizeof(T);
        if ((format_ == Format::big_endian) != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

    std::string_view text_;
    const std::string& file_;
    TextCursor cursor_;
    Format format_;
    std::size_t at_;
    const Element* element_ = nullptr;
    std::uint64_t index_ = 0;
};

/// The place of a vertex property: 0–2 position, 3–5 normal, 6–7 uv, -1 nowhere.
int vertex_slot(const std::string& name) {
    static constexpr std::array<std::array<std::string_view, 3>, 8> names{{{"x", "x", "x"},
                                                                           {"y", "y", "y"},
                                                                           {"z", "z", "z"},
                                                                           {"nx", "nx", "nx"},
                                                                           {"ny", "ny", "ny"},
                                                                           {"nz", "nz", "nz"},
                                                                           {"u", "s", "texture_u"},
                                                                           {"v", "t", "texture_v"}}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(names[i], name) != names[i].end()) return static_cast<int>(i);
    }
    return -1;
}

void skip_list(Values& values, const Property& property) {
    const double count = values.next(*property.count_type, property.name);
    for (double i = 0; i < count; ++i) values.next(property.type, property.name);
}

void read_vertices(Values& values, const Element& element, Mesh& mesh) {
    std::vector<int> slots;
    std::array<bool, 8> has{};
    for (const Property& property : element.properties) {
        slots.push_back(property.count_type ? -1 : vertex_slot(property.name));
        if (slots.back() >= 0) has[static_cast<std::size_t>(slots.back())] = true;
    }
    const bool normals = has[3] && has[4] && has[5], uvs = has[6] && has[7];
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.start(element, i);
        if (i == 0 && !(has[0] && has[1] && has[2])) throw values.error("without the properties x, y and z");
        std::array<float, 8> v{};
        for (std::size_t p = 0; p < slots.size(); ++p) {
            const Property& property = element.properties[p];
            if (property.count_type) {
                skip_list(values, property);
                continue;
            }
            const double value = values.next(property.type, property.name);
            if (slots[p] < 0) continue;
            const auto rounded = static_cast<float>(value);
            if (!std::isfinite(rounded))
                throw values.error(fmt::format("{} is {}; finite floats are accepted", property.name, value));
            v[static_cast<std::size_t>(slots[p])] = rounded;
        }
        mesh.positions.push_back({v[0], v[1], v[2]});
        if (normals) mesh.normals.push_back({v[3], v[4], v[5]});
        if (uvs) mesh.uvs.push_back({v[6], v[7]});
        values.finish();
    }
}

void read_faces(Values& values, const Element& element, std::uint64_t vertices, Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.start(element, i);
        for (const Property& property : element.properties) {
            const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
            if (!property.count_type) {
                values.next(property.type, property.name);
            } else if (!indices) {
                skip_list(values, property);
            } else {
                const double count = values.next(*property.count_type, property.name);
                if (count < 3) throw values.error(fmt::format("{} corners; 3 or more are accepted", count));
                corners.clear();
                for (double c = 0; c < count; ++c) {
                    const double index = values.next(property.type, property.name);
                    if (!(index >= 0 && index < static_cast<double>(vertices))) {
                        throw values.error(fmt::format("vertex index {}; there are {} vertices", index, vertices));
                    }
                    corners.push_back(static_cast<std::uint32_t>(index));
                }
                if (const std::string wrong = add_polygon(mesh, corners); !wrong.empty()) throw values.error(wrong);
            }
        }
        values.finish();
    }
}

void skip_elements(Values& values, const Element& element) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
        values.start(element, i);
        for (const Property& property : element.properties) {
            if (property.count_type)
                skip_list(values, property);
            else
                values.next(property.type, property.name);
        }
        values.finish();
    }
}

/// The elements with their properties, as a header has them.
std::string described(const Header& header) {
    std::string text;
    for (const Element& element : header.elements) {
        text += fmt::format("{}{} {} of", text.empty() ? "" : ", ", element.count, element.name);
        for (const Property& property : element.properties)
            text += (property.count_type ? " list " : " ") + property.name;
    }
    return text;
}

Mesh read_elements(const Header& header, Values values, const Element& vertex) {
    Mesh mesh;
    std::optional<Values> before_vertices;
    const Element* faces = nullptr;
    for (const Element& element : header.elements) {
        if (element.name == "vertex") {
            read_vertices(values, element, mesh);
        } else if (element.name == "face" && mesh.positions.size() == vertex.count) {
            read_faces(values, element, vertex.count, mesh);
        } else {
            if (element.name == "face") before_vertices.emplace(values), faces = &element;
            skip_elements(values, element);
        }
    }
    if (before_vertices) read_faces(*before_vertices, *faces, vertex.count, mesh);
    return mesh;
}

}  // namespace

Mesh read_ply(const std::filesystem::path& file) {
    const std::string text = read_file(file), name = file.string();
    TextCursor cursor(text, name);
    const Header header = read_header(cursor);
    const auto vertex = std::ranges::find(header.elements, "vertex", &Element::name);
    if (vertex == header.elements.end()) throw cursor.error("PLY header without the element 'vertex'");
    for (const Element& element : header.elements) {
        // A count that the file cannot hold is found before memory is asked for.
        if (element.count > text.size())
            throw cursor.error(
                fmt::format("{} {} elements in a file of {} bytes", element.count, element.name, text.size()));
    }
    Mesh mesh = read_elements(header, Values(text, name, cursor, header.format), *vertex);
    if (mesh.triangles.empty())
        throw Error(
            fmt::format("{}: no faces: it has {}; accepted is the element 'face' with the list vertex_indices "
                        "or vertex_index",
                        name, described(header)));
    return mesh;
}

}  // namespace plumb
