#include "scenes/mitsuba/mitsuba_xml.h"

#include <cmath>
#include <numbers>

#include "scenes/spectra/metals.h"
#include "scenes/spectra/tabulated_spectrum.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

using description::ConstantSky;
using description::Dielectric;
using description::Diffuse;
using description::Disk;
using description::Mask;
using description::MaterialId;
using description::Note;
using description::Scene;
using description::Sensor;
using description::Sphere;
using description::TwoSided;

class MitsubaXml : public testing_files::Folder {
protected:
    Scene load(const std::string& body, const LoadOptions& options = {}) const {
        return load_mitsuba(write("a.xml", "<scene version=\"3.0.0\">\n" + body + "\n</scene>\n"), options);
    }
    std::string says(const std::string& body, const LoadOptions& options = {}) const {
        return message([&] { return load(body, options); });
    }
};

TEST_F(MitsubaXml, ReadsBothSpellings) {
    const Scene scene = load(R"(<bsdf type="roughdielectric" id="glass">
        <float name="intIOR" value="1.5"/><string name="ext_ior" value="water"/><float name="alpha" value=".3"/></bsdf>
      <shape type="sphere"><point name="center" x="1" y="2" z="3"/><float name="radius" value="2"/><ref id="glass"/>
        <transform name="toWorld"><scale value="2"/><translate x="10"/></transform></shape>)");
    const auto& glass = std::get<Dielectric>(scene.materials.at(0).kind);
    EXPECT_DOUBLE_EQ(glass.eta, 1.5 / 1.333);
    EXPECT_DOUBLE_EQ(glass.roughness.value().alpha, 0.3);
    const auto& sphere = std::get<Sphere>(scene.shapes.at(0).geometry);
    EXPECT_EQ(sphere.center, (Vec3{12, 4, 6}));
    EXPECT_DOUBLE_EQ(sphere.radius, 4);
    EXPECT_EQ(scene.shapes[0].material, (MaterialId{0}));
    EXPECT_EQ(scene.shapes[0].place.line, 4);
}

TEST_F(MitsubaXml, NestsMaterialsAndFollowsRefsForwards) {
    const Scene scene = load(R"(<shape type="cube"><ref id="leaf"/></shape>
      <bsdf type="mask" id="leaf"><float name="opacity" value="0.25"/><bsdf type="twosided"><ref id="red"/></bsdf></bsdf>
      <bsdf type="diffuse" id="red"><rgb name="reflectance" value="#ff0000"/></bsdf>)");
    const auto& mask = std::get<Mask>(scene.materials.at(scene.shapes.at(0).material.index).kind);
    EXPECT_EQ(std::get<Spectrum>(mask.opacity), Spectrum::grey(0.25));
    const auto& sides = std::get<TwoSided>(scene.materials.at(mask.nested.index).kind);
    EXPECT_EQ(sides.front, sides.back);
    const auto& red = std::get<Diffuse>(scene.materials.at(sides.front.index).kind);
    EXPECT_EQ(std::get<Spectrum>(red.reflectance), Spectrum::rgb(1, 0, 0));
    EXPECT_EQ(scene.materials.size(), 3u);
}

TEST_F(MitsubaXml, ReadsSensorFilmAndEmitters) {
    const Scene scene = load(R"(<default name="side" value="100"/>
      <integrator type="volpath"/>
      <sensor type="thinlens"><float name="fov" value="90"/><string name="fov_axis" value="y"/>
        <float name="aperture_radius" value="0.1"/><float name="focus_distance" value="3"/><float name="near_clip" value="1"/>
        <film type="hdrfilm"><integer name="width" value="200"/><integer name="height" value="$side"/>
          <rfilter type="tent"/></film></sensor>
      <emitter type="constant"><rgb name="radiance" value="1 2 3"/></emitter>
      <emitter type="point"><point name="position" value="1, 2, 3"/></emitter>
      <shape type="disk"><transform name="to_world"><scale value="2"/></transform>
        <emitter type="area"><rgb name="radiance" value="5"/></emitter></shape>)",
                             {.definitions = {{"side", "50"}}});
    const Sensor& sensor = scene.sensor.value();
    EXPECT_EQ(sensor.film.height, 50);
    const auto& lens = std::get<description::ThinLens>(sensor.kind);
    EXPECT_NEAR(lens.fov_x, 2 * std::atan(4.0) * 180 / std::numbers::pi, 1e-12);  // 200 by 50, 90 degrees down
    EXPECT_EQ(std::get<TentFilter>(sensor.film.filter).radius(), 1);
    EXPECT_EQ(lens.aperture_radius, 0.1);
    EXPECT_EQ(std::get<ConstantSky>(scene.emitters.at(0).kind).radiance, Spectrum::rgb(1, 2, 3));
    EXPECT_EQ(std::get<description::PointLight>(scene.emitters.at(1).kind).position, (Vec3{1, 2, 3}));
    EXPECT_EQ(std::get<Disk>(scene.shapes.at(0).geometry).axis_x, (Vec3{2, 0, 0}));
    EXPECT_TRUE(scene.shapes[0].emitter);
    ASSERT_EQ(scene.notes.size(), 2u);
    EXPECT_EQ(scene.notes[0].text, "integrator 'volpath'");
    EXPECT_EQ(scene.notes[1].text, "'near_clip' of thinlens");
}

TEST_F(MitsubaXml, IncludesAndRefusesToIncludeItself) {
    write("b.xml", "<scene><bsdf type=\"diffuse\" id=\"x\"/></scene>");
    EXPECT_EQ(load("<include filename=\"b.xml\"/><shape type=\"cube\"><ref id=\"x\"/></shape>").materials.size(), 1u);
    write("c.xml", "<scene>\n\n<include filename=\"a.xml\"/></scene>");
    EXPECT_EQ(says("<include filename=\"c.xml\"/>"), "c.xml:3: include of a.xml, which is being read already");
    EXPECT_EQ(says("<include filename=\"d.xml\"/>"), "a.xml:2: there is no file d.xml");
}

TEST_F(MitsubaXml, LenientReplacesAndLists) {
    const std::string body =
        R"(<bsdf type="bumpmap" id="b"><texture name="map" type="wood"/><bsdf type="plastic"/></bsdf>
<shape type="cube"><bsdf type="hair"><float name="longitude" value="1"/></bsdf></shape>)";
    EXPECT_EQ(says(body).substr(0, 50), "a.xml:2: unknown bsdf 'bumpmap'; there are conduct");
    const Scene scene = load(body, {.lenient = true});
    ASSERT_EQ(scene.notes.size(), 4u);  // and that nothing refers to the first, and that there is no sensor
    EXPECT_EQ(scene.notes[0].text, "bsdf 'bumpmap' by its child");
    EXPECT_EQ(scene.notes[1].text, "bsdf 'hair' by grey diffuse");
    EXPECT_EQ(scene.notes[1].place.line, 3);
    EXPECT_EQ(scene.notes[1].kind, Note::Kind::replaced);
    // What has no replacement stays an error.
    EXPECT_EQ(says("<shape type=\"torus\"/>", {.lenient = true}),
              "a.xml:2: unknown shape 'torus'; there are cube, disk, obj, ply, rectangle, sphere");
}

TEST_F(MitsubaXml, ErrorsNameFileLineAndValue) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"<shape type=\"cube\">", "a.xml:3: malformed XML: Start-end tags mismatch"},
        {"<shape/>", "a.xml:2: <shape> without the attribute 'type'"},
        {"\n<emitter type=\"sun\"/>", "a.xml:3: unknown emitter 'sun'; there are area, constant, envmap, point"},
        {"<shape type=\"obj\"><string name=\"filename\" value=\"x.obj\"/></shape>", "a.xml:2: there is no file x.obj"},
        {"<shape type=\"obj\"/>", "a.xml:2: <shape> without a 'filename'"},
        {"<shape type=\"cube\"><ref id=\"wood\"/></shape>", "a.xml:2: <ref> to 'wood', but nothing has this id"},
        {"<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>", "a.xml:2: a bsdf that contains itself"},
        {"<bsdf type=\"diffuse\" id=\"a\"/>\n<bsdf type=\"diffuse\" id=\"a\"/>",
         "a.xml:3: the id 'a' is taken by line 2"},
        {"<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0 2 0\"/></bsdf>",
         "a.xml:2: reflectance is 2; values from 0 to 1 are accepted"},
        {"<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0 x 0\"/></bsdf>",
         "a.xml:2: 'x' where a finite number is expected"},
        {"<bsdf type=\"diffuse\"><rgb name=\"reflectence\" value=\"0\"/></bsdf>",
         "a.xml:2: unknown property of diffuse 'reflectence'; did you mean 'reflectance'?"},
        {"<bsdf type=\"roughplastic\"><float name=\"alpha\" value=\"0\"/></bsdf>",
         "a.xml:2: alpha is 0; roughness above 0 is accepted"},
        {"<bsdf type=\"twosided\"/>", "a.xml:2: 'twosided' around 0 bsdfs; 1 or 2 is accepted"},
        {"<shape type=\"cube\"><transform name=\"to_world\">\n<scale x=\"0\"/></transform></shape>",
         "a.xml:3: singular transform (determinant 0); an invertible one is accepted"},
        {"<shape type=\"sphere\"><transform name=\"to_world\"><scale x=\"2\"/></transform></shape>",
         "a.xml:2: a sphere scaled by 2 1 1; uniform scaling is accepted"},
        {"<shape type=\"sphere\"><float name=\"radius\" value=\"-1\"/></shape>",
         "a.xml:2: a sphere of radius -1; above 0 is accepted"},
        {"<emitter type=\"constant\"><rgb name=\"radiance\" value=\"-1\"/></emitter>",
         "a.xml:2: radiance is -1; values from 0 are accepted"},
        {"<emitter type=\"area\"/>", "a.xml:2: emitter 'area' outside a shape"},
        {"<sensor type=\"perspective\"><float name=\"fov\" value=\"180\"/></sensor>",
         "a.xml:2: fov is 180; angles between 0 and 180 degrees are accepted"},
        {"<sensor type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" value=\"0\"/></film></sensor>",
         "a.xml:2: a film of 0×576; 1 to 65536 pixels a side are accepted"},
        {"<float name=\"x\" value=\"$y\"/>", "a.xml:2: $y has no value; give -D y=… or a <default> before it"},
        {"<medium type=\"x\"/>",
         "a.xml:2: <medium> within <scene>, where nothing takes it; accepted are <alias> and <bsdf>"},
    };
    for (const auto& [body, expected] : cases) EXPECT_EQ(says(body).substr(0, expected.size()), expected) << body;
    EXPECT_EQ(says("", {.definitions = {{"sp", "1"}}}), "-D sp: nothing in the scene asks for $sp");
    EXPECT_EQ(message([&] { return load_mitsuba(path_ / "none.xml"); }), "cannot read the scene file none.xml");
    EXPECT_EQ(message([&] { return load_mitsuba(write("e.xml", "<a/>")); }),
              "e.xml:1: the root element is <a>; <scene> is accepted");
}

TEST_F(MitsubaXml, AnEmitterNeedsArea) {
    write("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    EXPECT_EQ(
        says("<shape type=\"obj\"><string name=\"filename\" value=\"flat.obj\"/><emitter type=\"area\"/></shape>"),
        "a.xml:2: an area emitter on a mesh of area 0; above 0 is accepted");
}

TEST(TabulatedSpectrum, FlatReflectanceIsWhiteAndFlatEmissionHasUnitLuminance) {
    const TabulatedSpectrum flat{{300, 0.5}, {900, 0.5}};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(reflectance_rgb(flat)[i], 0.5, 1e-12);
    EXPECT_NEAR(luminance(emission_rgb(flat)), 0.5, 1e-12);
    // Equal-energy white in linear sRGB: (1.2048, 0.9483, 0.9087) over its luminance of 1 [from XYZ = (1, 1, 1)].
    EXPECT_NEAR(emission_rgb(flat)[0], 0.6024, 5e-3);
    const Spectrum red = reflectance_rgb({{380, 0}, {600, 0}, {601, 1}, {780, 1}});
    EXPECT_GT(red[0], 3 * red[1]);
}

TEST(Metals, UnknownOnesAreNamed) {
    EXPECT_GT(metal("Cu").k[0], 3);
    EXPECT_THROW(metal("Unobtainium"), Error);
    EXPECT_DOUBLE_EQ(named_index("water"), 1.333);
}

}  // namespace
}  // namespace plumb
