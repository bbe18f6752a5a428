// What scene files of several versions and authors say in several ways.

#include <cmath>
#include <numbers>

#include "scenes/mitsuba/written_scenes.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing_files::bsdf;
using testing_files::shape;
using testing_files::with_sensor;

class Spellings : public testing_files::WrittenScenes {};

TEST_F(Spellings, VersionsDecideWhatAConductorOfNoMetalIs) {
    const auto metal = [&](const std::string& scene) {
        return std::get<description::Conductor>(load_mitsuba(write("a.xml", scene)).materials.at(0).kind);
    };
    const std::string bare = "<bsdf type=\"conductor\" id=\"a\"/></scene>";
    for (const std::string version : {"0.4.0", "0.5.0", "0.6.0"}) {
        const auto copper = metal("<scene version=\"" + version + "\">" + bare);
        EXPECT_EQ(copper.eta, metal("<scene version=\"3.0.0\"><bsdf type=\"conductor\" id=\"a\">"
                                    "<string name=\"material\" value=\"Cu\"/>"
                                    "<string name=\"ext_eta\" value=\"air\"/></bsdf></scene>")
                                  .eta);
    }
    for (const std::string version : {"2.0.0", "3.0.0", "3.5.2"})
        EXPECT_FALSE(metal("<scene version=\"" + version + "\">" + bare).eta) << version;
    EXPECT_EQ(says_of_file("<scene>" + bare).substr(0, 40), "scene.xml:1: a conductor of no metal, wh");
    for (const std::string version : {"0.3.0", "4.0.0", "x", "", "-1"})
        EXPECT_EQ(says_of_file("<scene version=\"" + version + "\"/>"),
                  "scene.xml:1: a scene of version '" + version + "'; 0.4.0 to 3.x are accepted");
    // An included file has its own version, or that of the file that includes it.
    for (const auto& [attribute, is_mirror] : {std::pair{"", true}, {" version=\"0.6.0\"", false}}) {
        write("part.xml", std::string("<scene") + attribute + ">" + bare);
        EXPECT_EQ(!metal("<scene version=\"3.0.0\"><include filename=\"part.xml\"/></scene>").eta, is_mirror);
    }
}

TEST_F(Spellings, FilesAreFoundBesideTheirFileThenInTheFolders) {
    fs::create_directories(path_ / "parts");
    fs::create_directories(path_ / "meshes");
    for (const std::string file : {"here.obj", "parts/there.obj", "meshes/far.obj"})
        write(file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto part = [&](const std::string& mesh, const std::string& path = "") {
        write("parts/p.xml",
              "<scene><shape type=\"obj\"><string name=\"filename\" value=\"" + mesh + "\"/></shape></scene>");
        return says(path + "<include filename=\"parts/p.xml\"/>");
    };
    EXPECT_EQ(part("here.obj"), "nothing");
    EXPECT_EQ(part("there.obj"), "nothing");
    EXPECT_EQ(part("far.obj"), "parts/p.xml:1: there is no file parts/far.obj nor far.obj");
    EXPECT_EQ(part("far.obj", "<path value=\"meshes\"/>"), "nothing");
    EXPECT_EQ(part("no.obj", "<path value=\"meshes\"/>"),
              "parts/p.xml:1: there is no file parts/no.obj nor meshes/no.obj nor no.obj");
    EXPECT_EQ(says("<path value=\"no\"/>"), "scene.xml:2: there is no folder no");
    // An included file's root may be the thing itself.
    write("parts/ball.xml", "<shape version=\"3.0.0\" type=\"sphere\"/>");
    EXPECT_EQ(load("<include filename=\"parts/ball.xml\"/>").shapes.size(), 1u);
}

TEST_F(Spellings, ShapesMayReferToOneEmitter) {
    const auto scene = load("<emitter type=\"area\" id=\"e\"><rgb name=\"radiance\" value=\"2\"/></emitter>" +
                            shape("<ref id=\"e\"/>") + shape("<ref id=\"e\"/>"));
    ASSERT_EQ(scene.shapes.size(), 2u);
    for (const auto& lamp : scene.shapes) EXPECT_EQ(lamp.emitter.value().radiance, Spectrum::grey(2));
    EXPECT_EQ(says("<emitter type=\"area\" id=\"e\"/>"), "scene.xml:2: emitter 'area' outside a shape");
}

TEST_F(Spellings, CapitalsDoNotMatterInKeywords) {
    const auto index = [&](const std::string& medium) {
        const auto scene = load(bsdf("dielectric", "<string name=\"int_ior\" value=\"" + medium + "\"/>"));
        return std::get<description::Dielectric>(scene.materials.at(0).kind).eta;
    };
    EXPECT_EQ(index("Water"), index("water"));
    EXPECT_DOUBLE_EQ(index("fused quartz"), 1.458 / 1.000277);
    EXPECT_EQ(says(with_sensor("<float name=\"fov\" value=\"40\"/><string name=\"fovAxis\" value=\"Y\"/>")), "nothing");
    EXPECT_EQ(says(bsdf("roughplastic", "<string name=\"distribution\" value=\"GGX\"/>")), "nothing");
}

TEST_F(Spellings, ALensFocusesOnTheFarClipUnlessToldOtherwise) {
    const auto focus = [&](const std::string& inner) {
        const auto scene = load("<sensor type=\"thinlens\">" + inner + "</sensor>");
        return std::get<description::ThinLens>(scene.sensor.value().kind).focus_distance;
    };
    EXPECT_EQ(focus(""), 1e4);
    EXPECT_EQ(focus("<float name=\"far_clip\" value=\"50\"/>"), 50);
    EXPECT_EQ(focus("<float name=\"far_clip\" value=\"50\"/><float name=\"focus_distance\" value=\"3\"/>"), 3);
}

TEST_F(Spellings, AnAliasIsAnotherId) {
    const std::string red = bsdf("diffuse", "<rgb name=\"reflectance\" value=\"1 0 0\"/>");
    const auto scene = load(red + "<alias id=\"a\" as=\"b\"/>" + shape("<ref id=\"b\"/>"));
    EXPECT_EQ(scene.materials.size(), 1u);
    expect_errors({{"<alias id=\"a\" as=\"b\"/>", "scene.xml:2: <alias> of 'a', but nothing has this id"},
                   {red + "<alias id=\"a\" as=\"a\"/>", "scene.xml:2: the id 'a' is taken"}});
}

TEST_F(Spellings, TexturesTakeBothSizesOfMatrix) {
    const auto at = [&](const std::string& matrix) {
        const auto scene = load("<texture type=\"checkerboard\" id=\"t\"><transform name=\"to_uv\">" + matrix +
                                "</transform></texture>");
        return scene.textures.at(0).to_uv.point({0.25, 0.5, 0});
    };
    const Vec3 nine = at("<matrix value=\"2 1 0.5  0 3 0.25  0 0 1\"/>"),
               sixteen = at("<matrix value=\"2 1 0 0.5  0 3 0 0.25  0 0 1 0  0 0 0 1\"/>");
    EXPECT_EQ(nine, (Vec3{1.5, 1.75, 0}));
    EXPECT_EQ(nine, sixteen);
    EXPECT_EQ(at("<translate x=\"0.5\" y=\"2\"/>"), at("<matrix value=\"1 0 0.5  0 1 2  0 0 1\"/>"));
    EXPECT_THROW(at("<matrix value=\"2 1 0.5 0  0 3 0.25 0  0 0 1 0  0 0 0 1\"/>"), Error);
}

TEST_F(Spellings, LookAtFindsItsUpright) {
    const auto up_of = [&](const std::string& attributes) {
        const auto scene = load(with_sensor("<transform name=\"to_world\"><lookat " + attributes + "/></transform>"));
        return scene.sensor.value().to_world.vector({0, 1, 0});
    };
    const std::string down = "origin=\"0 5 0\" target=\"0 0 0\"", aslant = "origin=\"1, 2, 3\" target=\"4, 4, 4\"";
    for (const std::string& view : {down, aslant}) {
        EXPECT_EQ(up_of(view), up_of(view + " up=\"0 0 0\""));
        EXPECT_NEAR(length(up_of(view)), 1, 1e-15);
    }
    // Along -y [Duff et al. 2017]: the first axis beside it is x.
    EXPECT_EQ(up_of(down), (Vec3{1, 0, 0}));
    EXPECT_EQ(says(with_sensor("<transform name=\"to_world\"><lookat " + down + " up=\"0 1 0\"/></transform>")),
              "scene.xml:2: lookat with up along the direction of view");
}

TEST_F(Spellings, SpectraAreSeparatedByBlanksOrCommas) {
    const auto reflectance = [&](const std::string& value) {
        const auto scene = load(bsdf("diffuse", "<spectrum name=\"reflectance\" value=\"" + value + "\"/>"));
        return std::get<Spectrum>(std::get<description::Diffuse>(scene.materials.at(0).kind).reflectance);
    };
    const Spectrum commas = reflectance("400:0.1, 500:0.2, 700:0.5");
    for (const std::string value : {"400:0.1 500:0.2 700:0.5", "400:0.1,500:0.2,700:0.5", " 400:0.1\n500:0.2\t700:0.5 ",
                                    "400 : 0.1, 500: 0.2, 700 :0.5"})
        EXPECT_EQ(reflectance(value), commas) << value;
    EXPECT_EQ(says(bsdf("diffuse", "<spectrum name=\"reflectance\" value=\"400:0.1 500\"/>")),
              "scene.xml:2: '500' where nm:value is expected");
}

TEST_F(Spellings, EqualRoughnessesAreOne) {
    const auto alpha = [&](const std::string& u, const std::string& v, const LoadOptions& options = {}) {
        const auto scene = load(bsdf("roughplastic", "<float name=\"alpha_u\" value=\"" + u +
                                                         "\"/><float name=\"alpha_v\" value=\"" + v + "\"/>"),
                                options);
        return std::get<description::Plastic>(scene.materials.at(0).kind).roughness.value().alpha;
    };
    EXPECT_EQ(alpha("0.2", "0.2"), 0.2);
    EXPECT_THROW(alpha("0.2", "0.3"), Error);
    EXPECT_EQ(alpha("0.2", "0.3", {.lenient = true}), 0.3);
}

TEST_F(Spellings, ASceneWithoutASensorIsSeen) {
    const auto scene = load("<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"2\" z=\"3\"/></shape>");
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0].text,
              "no <sensor> by a perspective one of 45 degrees at 1 2 -0.4142, which looks along +z");
    // As far before the box as half its side over the tangent of half the angle.
    const Vec3 from = scene.sensor.value().to_world.point({});
    EXPECT_NEAR(from.z, 2 - 1 / std::tan(std::numbers::pi / 8), 1e-12);
    EXPECT_EQ(load("").sensor.value().to_world.point({}), Vec3{});
}

TEST_F(Spellings, IntegratorsOfBothAreFollowedWithTheirLimits) {
    const auto integrator = [&](const std::string& type, const std::string& inner = "") {
        return load("<integrator type=\"" + type + "\">" + inner + "</integrator>").integrator;
    };
    const auto path =
        integrator("path", "<integer name=\"maxDepth\" value=\"4\"/><integer name=\"rr_depth\" value=\"2\"/>");
    EXPECT_EQ(path.value().name, "path");
    EXPECT_EQ(path->longest, 4);
    EXPECT_EQ(path->roulette_at, 2);
    EXPECT_EQ(integrator("ptracer").value().name, "light");
    EXPECT_FALSE(integrator("direct").value().longest);
    EXPECT_FALSE(integrator("volpath"));
    expect_errors({{"<integrator type=\"path\"><integer name=\"max_depht\" value=\"4\"/></integrator>",
                    "scene.xml:2: unknown property of path 'max_depht'; did you mean 'max_depth'?"},
                   {"<integrator type=\"path\"><integer name=\"max_depth\" value=\"-2\"/></integrator>",
                    "scene.xml:2: max_depth is -2; whole numbers from -1 are accepted"},
                   {"<integrator type=\"volpath\"><shape type=\"sphere\"/></integrator>",
                    "scene.xml:2: <shape> within volpath, where nothing takes it"},
                   {"<integrator type=\"path\"/>\n<integrator type=\"path\"/>",
                    "scene.xml:3: a second integrator; the first is in line 2"}});
}

}  // namespace
}  // namespace plumb
