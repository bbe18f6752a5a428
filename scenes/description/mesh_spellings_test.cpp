#include <bit>
#include <cstring>
#include <functional>

#include <fmt/format.h>

#include "scenes/description/obj.h"
#include "scenes/description/ply.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

using MeshSpellings = testing_files::Folder;

// A face with a notch and a triangle, with uvs and normals: every file below says this.
constexpr std::array<std::array<float, 3>, 9> positions{
    {{-1, -1, 0}, {0, -1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {2, 0, .5f}, {3, 0, .5f}, {2, 1, .5f}}};
const std::vector<std::vector<int>> faces{{0, 1, 2, 3, 4, 5}, {6, 7, 8}};

std::array<float, 2> uv(std::size_t i) {
    return {static_cast<float>(i) / 16, static_cast<float>(i) / 32};
}

void expect_equal(const Mesh& a, const Mesh& b, const std::string& what) {
    EXPECT_EQ(a.positions, b.positions) << what;
    EXPECT_EQ(a.normals, b.normals) << what;
    EXPECT_EQ(a.uvs, b.uvs) << what;
    EXPECT_EQ(a.triangles, b.triangles) << what;
}

std::string vertices_of_obj() {
    std::string text;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto& [x, y, z] = positions[i];
        text += fmt::format("v {} {} {}\nvt {} {}\nvn 0 0 1\n", x, y, z, uv(i)[0], 1 - uv(i)[1]);
    }
    return text;
}

std::string faces_of_obj(int from) {
    std::string text;
    for (const auto& face : faces) {
        text += "f";
        for (const int i : face) text += fmt::format(" {0}/{0}/{0}", i + from);
        text += "\n";
    }
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

template <class T>
void put(std::string& text, double value, bool big) {
    const T number = static_cast<T>(value);
    std::string bytes(sizeof number, ' ');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (big) std::ranges::reverse(bytes);
    text += bytes;
}

/// Writes a number of a type of PLY: as text, or as bytes of either order.
void put(std::string& text, const std::string& type, double value, const std::string& format) {
    const bool big = format == "binary_big_endian";
    if (format == "ascii")
        text += fmt::format("{} ", value);
    else if (type == "char" || type == "int8")
        put<std::int8_t>(text, value, big);
    else if (type == "uchar" || type == "uint8")
        put<std::uint8_t>(text, value, big);
    else if (type == "short" || type == "int16")
        put<std::int16_t>(text, value, big);
    else if (type == "ushort" || type == "uint16")
        put<std::uint16_t>(text, value, big);
    else if (type == "int" || type == "int32")
        put<std::int32_t>(text, value, big);
    else if (type == "uint" || type == "uint32")
        put<std::uint32_t>(text, value, big);
    else if (type == "float" || type == "float32")
        put<float>(text, value, big);
    else
        put<double>(text, value, big);
}

/// The mesh as PLY, with a property and a list that are no business of ours in each element.
std::string ply(const std::string& format, const std::string& real, const std::string& count, const std::string& index,
                bool faces_first) {
    std::string vertex_header = fmt::format("element vertex {}\n", positions.size()), vertex_body, face_body;
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "u", "v"})
        vertex_header += fmt::format("property {} {}\n", real, name);
    vertex_header += fmt::format("property uchar red\nproperty list {} {} neighbours\n", count, index);
    const std::string face_header = fmt::format(
        "element face {}\nproperty short flags\nproperty list {} {} vertex_indices\nproperty list {} {} texcoord\n",
        faces.size(), count, index, count, real);
    const std::string end = format == "ascii" ? "\n" : "";
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto& [x, y, z] = positions[i];
        for (const float value : {x, y, z, 0.f, 0.f, 1.f, uv(i)[0], uv(i)[1]}) put(vertex_body, real, value, format);
        put(vertex_body, "uchar", 200, format);
        put(vertex_body, count, 2, format);
        for (const int neighbour : {1, 2}) put(vertex_body, index, neighbour, format);
        vertex_body += end;
    }
    for (const auto& face : faces) {
        put(face_body, "short", -7, format);
        put(face_body, count, static_cast<double>(face.size()), format);
        for (const int i : face) put(face_body, index, i, format);
        put(face_body, count, 1, format);
        put(face_body, real, 0.5, format);
        face_body += end;
    }
    std::string edge_body;
    put(edge_body, "double", 1.5, format);
    edge_body += end;
    const std::string head = "ply\nformat " + format + " 1.0\ncomment from C:\\x\\\nobj_info y\n";
    const std::string edge_header = "element edge 1\nproperty double crease\n";
    return faces_first
               ? head + face_header + edge_header + vertex_header + "end_header\n" + face_body + edge_body + vertex_body
               : head + vertex_header + edge_header + face_header + "end_header\n" + vertex_body + edge_body +
                     face_body;
}

TEST_F(MeshSpellings, EveryObjIsTheSameMesh) {
    const std::string vertices = vertices_of_obj(), plain = vertices + faces_of_obj(1);
    const Mesh mesh = read_obj(write("plain.obj", plain));
    ASSERT_EQ(mesh.positions.size(), positions.size());
    ASSERT_EQ(mesh.triangles.size(), 5u);
    const std::vector<std::pair<std::string, std::string>> spellings{
        {"CR LF", replaced(plain, "\n", "\r\n")},
        {"CR", replaced(plain, "\n", "\r")},
        {"a mark at the start", "\xEF\xBB\xBF" + plain},
        {"tabs", replaced(plain, " ", "\t")},
        {"blanks", "  \n\n" + replaced(replaced(plain, " ", "   "), "\n", " \n\n  ")},
        {"comments", "# C:\\\n" + replaced(plain, "\n", " # a comment \\\n")},
        {"lines that go on", replaced(plain, " ", " \\\n ")},
        {"lines that go on without blanks", replaced(plain, " ", " \\\r\n")},
        {"lines that go on at a word", replaced(plain, " ", "\\\n ")},
        {"groups", "mtllib a\\b.mtl\no thing\n" + vertices + "g a b\nusemtl a\\b\ns 1\n" +
                       replaced(faces_of_obj(1), "\nf", "\ns off\ng\nf")},
        {"indices that count back", vertices + faces_of_obj(-static_cast<int>(positions.size()))},
        {"faces first", faces_of_obj(1) + vertices},
        {"no newline at the end", plain.substr(0, plain.size() - 1)},
        {"points and lines", plain + "p 1 2\nl 1/1 2/2 \\\n 3/3\n"},
        {"weights and depths", replaced(replaced(plain, "\nvt", " 1\nvt"), "\nvn", " 0\nvn")},
        {"old faces", replaced(plain, "\nf ", "\nfo ")},
        {"signs and exponents", replaced(replaced(plain, " 1 ", " +1.000e+0 "), " 0 ", " -.0E1 ")}};
    for (const auto& [what, text] : spellings) expect_equal(read_obj(write("a.obj", text)), mesh, what);
}

TEST_F(MeshSpellings, EveryPlyIsTheSameMesh) {
    const Mesh mesh = read_obj(write("plain.obj", vertices_of_obj() + faces_of_obj(1)));
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        for (const std::string count : {"char", "uint8", "short", "uint16", "int32", "uint"}) {
            for (const std::string index : {"int8", "uchar", "int16", "ushort", "int", "uint32"}) {
                for (const std::string real : {"float", "float64"}) {
                    for (const bool faces_first : {false, true}) {
                        const std::string what = fmt::format("{} {} {} {} {}", format, count, index, real, faces_first);
                        const std::string text = ply(format, real, count, index, faces_first);
                        expect_equal(read_ply(write("a.ply", text)), mesh, what);
                    }
                }
            }
        }
    }
    const std::string ascii = ply("ascii", "float", "uchar", "int", false);
    expect_equal(read_ply(write("a.ply", replaced(ascii, "\n", "\r\n"))), mesh, "CR LF");
    expect_equal(read_ply(write("a.ply", replaced(ascii, "\n", "\r"))), mesh, "CR");
    expect_equal(read_ply(write("a.ply", "\xEF\xBB\xBF" + replaced(ascii, " ", "\t"))), mesh, "a mark and tabs");
}

TEST_F(MeshSpellings, AFaceWithoutUvsOrNormalsTakesNoOthersAway) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn .6 0 .8\n";
    const std::string triangle = "v 5 0 0\nv 6 0 0\nv 5 1 0\n";
    const std::string textured = "f 1/1/1 2/2/1 3/3/1 4/4/1\n", bare = "f 5 6 7\n";
    const Mesh alone = read_obj(write("a.obj", square + textured));
    for (const std::string& order : {textured + bare, bare + textured}) {
        const Mesh mesh = read_obj(write("b.obj", square + triangle + order));
        ASSERT_EQ(mesh.positions.size(), 7u);
        const std::size_t first = order == textured + bare ? 0 : 3, other = first == 0 ? 4 : 0;
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(mesh.uvs[first + i], alone.uvs[i]);
            EXPECT_EQ(mesh.normals[first + i], alone.normals[i]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(mesh.uvs[other + i], (std::array{0.f, 1.f}));
            EXPECT_EQ(mesh.normals[other + i], (std::array{0.f, 0.f, 1.f}));
        }
    }
}

}  // namespace
}  // namespace plumb
