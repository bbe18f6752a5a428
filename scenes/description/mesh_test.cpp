#include "scenes/description/mesh.h"

#include <cstring>

#include "scenes/description/obj.h"
#include "scenes/description/ply.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

using Meshes = testing_files::Folder;
using testing_files::Folder;

/// The flux of x/3 through a closed surface is its volume [Gauss]; positive where triangles face outwards.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        sum += dot(mesh.position(t[0]), cross(mesh.position(t[1]), mesh.position(t[2]))) / 6;
    }
    return sum;
}

TEST(Mesh, CubeFacesOutwardsUnderEveryTransform) {
    EXPECT_DOUBLE_EQ(volume(cube_mesh()), 8);
    EXPECT_DOUBLE_EQ(volume(transformed(cube_mesh(), Transform::scale({-1, 2, 1}))), 16);
    Mesh turned = cube_mesh();
    flip_normals(turned);
    EXPECT_DOUBLE_EQ(volume(turned), -8);
}

TEST(Mesh, SmoothNormalsOfASharedCornerWeighAngles) {
    Mesh corner;  // of a cube, whose three faces meet at right angles, one of them cut in two
    corner.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    corner.triangles = {{0, 4, 1}, {0, 2, 4}, {0, 3, 2}, {0, 1, 3}};
    add_smooth_normals(corner);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(corner.normals[0][i], -1 / std::sqrt(3.0), 1e-7);
}

TEST_F(Meshes, ReadsAnObj) {
    const auto file = write("a.obj",
                            "# quad\nv 0 0 0\nv 1 0 0 # right\nv 1 1 +0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                            "vn 0 0 1\ng part\nusemtl x\nf 1/1/1 2/2/1 3/3/1 -1/-1/-1\n");
    const Mesh mesh = read_obj(file);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.uvs.at(0), (std::array{0.f, 1.f}));
    EXPECT_EQ(mesh.normals.at(3), (std::array{0.f, 0.f, 1.f}));
    EXPECT_EQ(mesh.position(mesh.triangles[1][2]), (Vec3{0, 1, 0}));
}

TEST_F(Meshes, ObjErrorsNameLineAndValue) {
    const auto says = [&](const std::string& text) { return message([&] { return read_obj(write("a.obj", text)); }); };
    EXPECT_EQ(says("v 0 0 0\nv 1 nan 0\n"), "a.obj:2: a coordinate of v is 'nan'; a finite number is accepted");
    EXPECT_EQ(says("v 0 0\n"), "a.obj:1: a coordinate of v is missing");
    EXPECT_EQ(says("v 0 0 0\nv 1 0 0\nf 1 2 3\n"), "a.obj:3: a face's v index is 3; there are 2");
    EXPECT_EQ(says("v 0 0 0\nv 1 0 0\nf 1 2 0\n"), "a.obj:3: a face's v index is 0; there are 2");
    EXPECT_EQ(says("v 0 0 0\nf 1 -2 1\n"), "a.obj:2: a face's v index is -2; there are 1 before it");
    EXPECT_EQ(says("surf 0 1 0 1 1\n"), "a.obj:1: the free-form element 'surf'; faces (f) are accepted");
    EXPECT_EQ(says("v 0 0 \\\n0\n# C:\\\nv 1 x 0\n"), "a.obj:4: a coordinate of v is 'x'; a finite number is accepted");
    EXPECT_EQ(says("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n"),
              "a.obj:5: a face whose edges from corner to corner 1–2 and 3–4 cross or touch; faces without holes and "
              "crossings are accepted");
    EXPECT_EQ(says("v 0 0 0\nv 1 0 0\nf 1 2\n"), "a.obj:3: a face of 2 corners; 3 or more are accepted");
    EXPECT_EQ(says("v 0 0 0\nf 1/1 1/1 1/1\n"), "a.obj:2: a face's vt index is 1; there are 0");
    EXPECT_EQ(says("v 0 1e99 0\n"), "a.obj:1: a coordinate of v is '1e99'; a finite number is accepted");
    EXPECT_EQ(says("v 0 0 0\n"), "a.obj:2: no faces");
    EXPECT_EQ(message([&] { return read_obj(path_ / "b.obj"); }), "b.obj: cannot be read: there is no such file");
}

const std::string header =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

template <class T>
void put(std::string& text, T value, bool big) {
    std::string bytes(sizeof value, ' ');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
}

std::string binary_ply(bool big, float last = 1, std::int32_t index = 2) {
    std::string text = "ply\nformat binary_" + std::string(big ? "big" : "little") + "_endian 1.0\n" + header;
    for (const float x : {0.f, 1.f, last}) {
        put(text, x, big);
        put(text, 2 * x, big);
        put(text, x * x, big);
        text += 'r';
    }
    text += '\3';
    for (const std::int32_t i : {0, 1, index}) put(text, i, big);
    return text;
}

TEST_F(Meshes, ReadsPlyOfEveryFormat) {
    const std::string ascii = "ply\nformat ascii 1.0\ncomment x\n" + header + "0 0 0 9\n1 2 1 9\n3 6 9 9\n3 0 1 2\n";
    for (const std::string& text : {ascii, binary_ply(false, 3), binary_ply(true, 3)}) {
        const Mesh mesh = read_ply(write("a.ply", text));
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.position(2), (Vec3{3, 6, 9}));
        EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
        EXPECT_TRUE(mesh.normals.empty() && mesh.uvs.empty());
    }
}

TEST_F(Meshes, PlyErrorsNamePlaceAndValue) {
    const auto says = [&](const std::string& text) { return message([&] { return read_ply(write("a.ply", text)); }); };
    EXPECT_EQ(says(binary_ply(false, NAN)), "a.ply: vertex 2: x is nan; finite floats are accepted");
    EXPECT_EQ(says(binary_ply(false, 1, 3)), "a.ply: face 0: vertex index 3; there are 3 vertices");
    EXPECT_EQ(says(binary_ply(false, 1, -1)), "a.ply: face 0: vertex index -1; there are 3 vertices");
    const std::string whole = binary_ply(true);
    EXPECT_EQ(says(whole.substr(0, whole.size() - 1)), "a.ply: face 0: truncated: the file ends after 0 of 1");
    EXPECT_EQ(says(whole.substr(0, 23)), "a.ply:2: unknown PLY format 'binary_big_e'");
    EXPECT_EQ(says("obj\n"), "a.ply:1: not a PLY file: its first line is not 'ply'");
    EXPECT_EQ(says("ply\nformat ascii 1.0\nelement vertex 9999999999\n" + header).substr(0, 18), "a.ply:12: 99999999");
    EXPECT_EQ(says("ply\nformat ascii 1.0\n" + header + "0 0 0 9\n1 2 x 9\n"),
              "a.ply:12: z is 'x'; a finite number is accepted");
    EXPECT_EQ(says("ply\nformat ascii 1.0\n" + header + "0 0 0 9\n").substr(0, 8), "a.ply:12");
    EXPECT_EQ(says("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                   "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0\n"),
              "a.ply: no faces: it has 1 vertex of x y z, 1 tristrips of list vertex_indices; accepted is the element "
              "'face' with the list vertex_indices or vertex_index");
}

}  // namespace
}  // namespace plumb
