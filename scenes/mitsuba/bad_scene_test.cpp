// What a scene file may get wrong: every error is one line that names the file, the line in it and the value.

#include <cstring>

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/scene.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

class BadScene : public testing_files::Folder {
protected:
    /// What loading says of a scene whose second line is this.
    std::string says(const std::string& body) const {
        return message(
            [&] { return load_mitsuba(write("a.xml", "<scene version=\"3.0.0\">\n" + body + "\n</scene>\n")); });
    }
    std::string says_of_mesh(const std::string& name, const std::string& text) const {
        write(name, text);
        return says("<shape type=\"" + name.substr(2) + "\"><string name=\"filename\" value=\"" + name +
                    "\"/></shape>");
    }
    std::string says_of_bsdf(const std::string& type, const std::string& properties) const {
        return says("<bsdf type=\"" + type + "\" id=\"a\">" + properties + "</bsdf>");
    }
};

std::string number(const std::string& name, const std::string& value) {
    return "<float name=\"" + name + "\" value=\"" + value + "\"/>";
}
std::string colour(const std::string& name, const std::string& value) {
    return "<rgb name=\"" + name + "\" value=\"" + value + "\"/>";
}

std::string binary_ply(float last_x, std::int32_t last_index) {
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const auto put = [&](const auto& value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, last_x, 1.f, 0.f}) put(x);
    text += '\3';
    for (const std::int32_t i : {0, 1, last_index}) put(i);
    return text;
}

TEST_F(BadScene, MissingFiles) {
    for (const std::string element :
         {"shape type=\"ply\"", "shape type=\"obj\"", "emitter type=\"envmap\"", "texture type=\"bitmap\" id=\"t\""}) {
        const std::string tag = element.substr(0, element.find(' '));
        EXPECT_EQ(says("<" + element + ">\n<string name=\"filename\" value=\"no/x\"/></" + tag + ">"),
                  "a.xml:3: there is no file no/x");
    }
    EXPECT_EQ(says("<include filename=\"b.xml\"/>"), "a.xml:2: there is no file b.xml");
}

TEST_F(BadScene, TruncatedMeshes) {
    const std::string whole = binary_ply(0, 2);
    EXPECT_EQ(says_of_mesh("m.ply", whole), "nothing");
    EXPECT_EQ(says_of_mesh("m.ply", whole.substr(0, whole.size() - 1)),
              "m.ply: face 0: truncated: the file ends after 0 of 1");
    EXPECT_EQ(says_of_mesh("m.ply", whole.substr(0, whole.size() - 20)),
              "m.ply: vertex 2: truncated: the file ends after 2 of 3");
    EXPECT_EQ(says_of_mesh("m.ply", whole.substr(0, 60)), "m.ply:5: truncated: no end_header");
    EXPECT_EQ(says_of_mesh("m.obj", "v 0 0 0\nv 1 0"), "m.obj:2: a coordinate of v is missing");
    EXPECT_EQ(says_of_mesh("m.obj", ""), "m.obj:1: no faces");
    EXPECT_EQ(says_of_mesh("m.ply", ""), "m.ply:1: not a PLY file: its first line is not 'ply'");
}

TEST_F(BadScene, IndicesOutOfRange) {
    EXPECT_EQ(says_of_mesh("m.ply", binary_ply(0, 3)), "m.ply: face 0: vertex index 3; there are 3 vertices");
    EXPECT_EQ(says_of_mesh("m.ply", binary_ply(0, -1)), "m.ply: face 0: vertex index -1; there are 3 vertices");
    EXPECT_EQ(says_of_mesh("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"),
              "m.obj:4: a face's v index is -4; there are 3 before it");
}

TEST_F(BadScene, VerticesThatAreNotFinite) {
    EXPECT_EQ(says_of_mesh("m.ply", binary_ply(NAN, 2)), "m.ply: vertex 2: x is nan; finite floats are accepted");
    EXPECT_EQ(says_of_mesh("m.obj", "v 0 0 inf\n"), "m.obj:1: a coordinate of v is 'inf'; a finite number is accepted");
    // Finite in the file, and no float in the scene.
    write("m.ply", binary_ply(1, 2));
    EXPECT_EQ(says("<shape type=\"ply\"><string name=\"filename\" value=\"m.ply\"/>\n<transform name=\"to_world\">"
                   "<scale value=\"1e39\"/></transform></shape>"),
              "a.xml:2: vertex 1 has the coordinate inf; finite floats are accepted");
}

TEST_F(BadScene, SingularTransforms) {
    const auto step = [&](const std::string& text) {
        return says("<shape type=\"cube\"><transform name=\"to_world\">\n" + text + "</transform></shape>");
    };
    EXPECT_EQ(step("<scale x=\"0\"/>"), "a.xml:3: singular transform (determinant 0); an invertible one is accepted");
    EXPECT_EQ(step("<matrix value=\"1 2 3 2 4 6 0 0 1\"/>"),
              "a.xml:3: singular transform (determinant 0); an invertible one is accepted");
    EXPECT_EQ(step("<matrix value=\"1 2\"/>"), "a.xml:3: a matrix of 2 numbers; 16 or 9 are accepted");
    EXPECT_EQ(step("<rotate angle=\"9\"/>"), "a.xml:3: rotation about the axis 0 0 0; another axis is accepted");
    EXPECT_EQ(step("<lookat origin=\"1 1 1\" target=\"1 1 1\" up=\"0 1 0\"/>"),
              "a.xml:3: lookat with its target at its origin");
}

TEST_F(BadScene, RecursiveIncludes) {
    write("b.xml", "<scene>\n\n<include filename=\"a.xml\"/></scene>");
    EXPECT_EQ(says("<include filename=\"b.xml\"/>"), "b.xml:3: include of a.xml, which is being read already");
    EXPECT_EQ(says("<include filename=\"a.xml\"/>"), "a.xml:2: include of a.xml, which is being read already");
}

TEST_F(BadScene, ElementsNestedWithoutEnd) {
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<bsdf type=\"twosided\">";
    for (int i = 0; i < 100'000; ++i) deep += "</bsdf>";
    EXPECT_EQ(says(deep), "a.xml:2: elements nested deeper than 100; that many are accepted");
}

TEST_F(BadScene, LightsWithNoArea) {
    write("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    EXPECT_EQ(
        says("<shape type=\"obj\"><string name=\"filename\" value=\"flat.obj\"/>\n<emitter type=\"area\"/></shape>"),
        "a.xml:3: an area emitter on a mesh of area 0; above 0 is accepted");
    EXPECT_EQ(says("<shape type=\"sphere\"><float name=\"radius\" value=\"0\"/><emitter type=\"area\"/></shape>"),
              "a.xml:2: a sphere of radius 0; above 0 is accepted");
}

TEST_F(BadScene, FilmOfNoPixels) {
    const auto film = [&](const std::string& width, const std::string& height) {
        return says("<sensor type=\"perspective\">\n<film type=\"hdrfilm\"><integer name=\"width\" value=\"" + width +
                    "\"/><integer name=\"height\" value=\"" + height + "\"/></film></sensor>");
    };
    EXPECT_EQ(film("0", "9"), "a.xml:3: a film of 0×9; 1 to 65536 pixels a side are accepted");
    EXPECT_EQ(film("9", "-1"), "a.xml:3: a film of 9×-1; 1 to 65536 pixels a side are accepted");
    EXPECT_EQ(film("9", "1.5"), "a.xml:3: height is 1.5; a whole number is accepted");
    EXPECT_EQ(film("9", "99999"), "a.xml:3: a film of 9×99999; 1 to 65536 pixels a side are accepted");
}

TEST_F(BadScene, Radiance) {
    const auto area = [&](const std::string& value) {
        return says("<shape type=\"cube\"><emitter type=\"area\">\n" + colour("radiance", value) +
                    "</emitter></shape>");
    };
    EXPECT_EQ(area("1 nan 1"), "a.xml:3: 'nan' where a finite number is expected");
    EXPECT_EQ(area("1 1e999 1"), "a.xml:3: '1e999' where a finite number is expected");
    EXPECT_EQ(area("1 1 -0.5"), "a.xml:3: radiance is -0.5; values from 0 are accepted");
    EXPECT_EQ(says("<emitter type=\"point\">" + colour("intensity", "-2") + "</emitter>"),
              "a.xml:2: intensity is -2; values from 0 are accepted");
}

TEST_F(BadScene, FieldOfViewAndLens) {
    const auto sensor = [&](const std::string& properties) {
        return says("<sensor type=\"thinlens\">\n" + properties + "</sensor>");
    };
    for (const std::string fov : {"0", "-40", "180"})
        EXPECT_EQ(sensor(number("fov", fov)),
                  "a.xml:3: fov is " + fov + "; angles between 0 and 180 degrees are accepted");
    EXPECT_EQ(sensor(number("aperture_radius", "-1")), "a.xml:3: aperture_radius is -1; values from 0 are accepted");
    EXPECT_EQ(sensor(number("focus_distance", "0")), "a.xml:3: focus_distance is 0; values above 0 are accepted");
}

TEST_F(BadScene, Roughness) {
    for (const std::string alpha : {"0", "-0.1"})
        for (const std::string type : {"roughconductor", "roughdielectric", "roughplastic"})
            EXPECT_EQ(says_of_bsdf(type, "\n" + number("alpha", alpha)),
                      "a.xml:3: alpha is " + alpha + "; roughness above 0 is accepted");
}

TEST_F(BadScene, Indices) {
    for (const std::string type : {"dielectric", "roughdielectric", "plastic", "roughplastic"}) {
        EXPECT_EQ(says_of_bsdf(type, "\n" + number("int_ior", "0")),
                  "a.xml:3: int_ior is 0; indices above 0 are accepted");
        EXPECT_EQ(says_of_bsdf(type, number("ext_ior", "-1")), "a.xml:2: ext_ior is -1; indices above 0 are accepted");
    }
    EXPECT_EQ(says_of_bsdf("conductor", "\n" + colour("eta", "1 -1 1") + colour("k", "1")),
              "a.xml:3: eta is -1; values from 0 are accepted");
    EXPECT_EQ(says_of_bsdf("conductor", "<string name=\"material\" value=\"Xx\"/>").substr(0, 30),
              "a.xml:2: unknown metal 'Xx'; d");
    EXPECT_EQ(message([&] {
                  return Scene(load_mitsuba(write("a.xml", "<scene>\n<bsdf type=\"plastic\" id=\"a\">" +
                                                               number("int_ior", "1") + "</bsdf></scene>")));
              }).substr(0, 45),
              "a.xml:2: int_ior over ext_ior is 0.9997230767");
}

TEST_F(BadScene, ReflectanceOutsideOfZeroToOne) {
    for (const std::string value : {"1.5", "-0.25"}) {
        EXPECT_EQ(says_of_bsdf("diffuse", "\n" + colour("reflectance", value)),
                  "a.xml:3: reflectance is " + value + "; values from 0 to 1 are accepted");
        EXPECT_EQ(says_of_bsdf("mask", "\n" + number("opacity", value) + "<bsdf type=\"diffuse\"/>"),
                  "a.xml:3: opacity is " + value + "; values from 0 to 1 are accepted");
        EXPECT_EQ(says("<texture type=\"checkerboard\" id=\"t\">\n" + colour("color1", value) + "</texture>"),
                  "a.xml:3: color1 is " + value + "; values from 0 to 1 are accepted");
    }
}

}  // namespace
}  // namespace plumb
