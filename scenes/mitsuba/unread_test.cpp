// What nobody reads in a scene file is an error that says what is accepted, or is listed.

#include "scenes/mitsuba/written_scenes.h"

namespace plumb {
namespace {

using description::Note;
using testing_files::bsdf;
using testing_files::shape;
using testing_files::with_sensor;

class Unread : public testing_files::WrittenScenes {};

TEST_F(Unread, ErrorsNameWhatIsAcceptedInItsPlace) {
    expect_errors({
        {bsdf("diffuse", "<texture type=\"checkerboard\"/>"),
         "scene.xml:2: <texture> without a name within diffuse; accepted are values by the names diffuse_reflectance"},
        {bsdf("diffuse", "<rgb value=\"1\"/>"), "scene.xml:2: <rgb> without a name within diffuse; accepted are"},
        {bsdf("diffuse", "<bsdf type=\"diffuse\"/>"),
         "scene.xml:2: <bsdf> within diffuse, where nothing takes it; accepted are"},
        {bsdf("twosided", "<bsdff type=\"diffuse\"/>"),
         "scene.xml:2: unknown element <bsdff> within twosided; did you mean <bsdf>?"},
        {bsdf("diffuse", "<rgb name=\"reflectance\" value=\"1\" scale=\"2\"/>"),
         "scene.xml:2: unknown attribute of <rgb> 'scale'"},
        {bsdf("diffuse", "<rgb name=\"reflectance\" valu=\"1\"/>"),
         "scene.xml:2: <rgb> without the attribute 'value'; it has 'name', 'valu'"},
        {bsdf("diffuse", "<flaot name=\"reflectance\" value=\"1\"/>"),
         "scene.xml:2: unknown element <flaot> within diffuse; did you mean <float>?"},
        {bsdf("roughconductor", "<texture type=\"checkerboard\" name=\"alpha\"/>"),
         "scene.xml:2: alpha is a <texture>; accepted is a number (<float>, <integer>)"},
        {bsdf("conductor", "<spectrum name=\"eta\" filename=\"a.spd\"/><rgb name=\"k\" value=\"1\"/>"),
         "scene.xml:2: a spectrum from a file; one number"},
        {bsdf("diffuse", "<spectrum type=\"uniform\" name=\"reflectance\"/>"),
         "scene.xml:2: a spectrum of type 'uniform'; one number"},
        {bsdf("diffuse", "<rgb name=\"reflectance\" value=\"0.5\"><float name=\"scale\" value=\"2\"/></rgb>"),
         "scene.xml:2: 'scale' within <rgb>; nothing is accepted there"},
        {shape("<emitter type=\"area\"><blackbody name=\"radiance\" temperature=\"5000\"/></emitter>"),
         "scene.xml:2: radiance is a <blackbody>; accepted is a constant"},
        {shape("<bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/>"),
         "scene.xml:2: 2 bsdf elements in sphere; one is accepted"},
        {shape("<transform><translate x=\"1\"/></transform>"),
         "scene.xml:2: <transform> without a name within sphere; accepted"},
        {shape("<transform name=\"to_world\"><translate X=\"1\"/></transform>"),
         "scene.xml:2: unknown attribute of <translate> 'X'; did you mean 'x'?"},
        {shape("<transform name=\"to_world\"><scale value=\"2\" x=\"1\"/></transform>"),
         "scene.xml:2: value and x of <scale> are given; one way is accepted"},
        {shape("<ref id=\"b\"/>") + bsdf("diffuse", ""), "scene.xml:2: <ref> to 'b', but nothing has this id"},
        {"<shape type=\"obj\"><string name=\"filenam\" value=\"a.obj\"/></shape>",
         "scene.xml:2: <shape> without a 'filename'; it has 'filenam'"},
        {"<bsdf type=\"diffuse\"/>", "scene.xml:2: bsdf 'diffuse' at the root without an id"},
        {"<float name=\"radius\" value=\"1\"/>", "scene.xml:2: 'radius' within <scene>; accepted are <alias> and"},
        {shape("text"), "scene.xml:2: the text 'text' within <shape>; values stand in attributes"},
    });
}

TEST_F(Unread, OfTwoWaysToSayOneThingOneIsAccepted) {
    const std::string fov = "<float name=\"fov\" value=\"40\"/>", axis = "<string name=\"fov_axis\" value=\"y\"/>",
                      focal = "<string name=\"focal_length\" value=\"50mm\"/>";
    const auto rgb = [](const std::string& name) { return "<rgb name=\"" + name + "\" value=\"0.5\"/>"; };
    expect_errors({
        {with_sensor(fov + focal), "scene.xml:2: focal_length is given, and fov"},
        {with_sensor(axis), "scene.xml:2: fov_axis is given without fov"},
        {bsdf("diffuse", rgb("reflectance") + rgb("diffuse_reflectance")), "scene.xml:2: reflectance is given, and"},
        {bsdf("conductor", rgb("eta") + rgb("k") + "<string name=\"material\" value=\"Cu\"/>"),
         "scene.xml:2: material is given, and eta"},
        {bsdf("roughplastic", "<float name=\"alpha\" value=\"0.1\"/><float name=\"alpha_u\" value=\"0.1\"/>"),
         "scene.xml:2: alpha is given, and alpha_u"},
        {with_sensor("<string name=\"toWorld\" value=\"\"/><string name=\"to_world\" value=\"\"/>"),
         "scene.xml:2: 'to_world' is given twice"},
    });
    EXPECT_EQ(says_of_file("<scene version=\"3.0.0\"><shape type=\"cube\" type=\"sphere\"/></scene>"),
              "scene.xml:1: the attribute 'type' of <shape> is given twice");
    EXPECT_EQ(says("<default name=\"a\" value=\"1\"/><default name=\"a\" value=\"2\"/>"),
              "scene.xml:2: a second <default> of 'a'; the first is in line 2");
}

TEST_F(Unread, NothingStandsBesideTheRoot) {
    EXPECT_EQ(says_of_file("<scene version=\"3.0.0\"/>\n<scene version=\"3.0.0\"/>"),
              "scene.xml:2: <scene> after the end of <scene>; one root element is accepted");
    EXPECT_EQ(says_of_file("<scene version=\"3.0.0\"/>\n<!-- fine --> more"),
              "scene.xml:2: the text ' more' beside <scene>; one root element is accepted");
    EXPECT_EQ(says_of_file("<!-- nothing -->"), "scene.xml:1: no element; <scene> is accepted");
}

TEST_F(Unread, AnIdMayStandWithinWhatNobodyRefersTo) {
    const auto scene =
        load("<bsdf type=\"twosided\">" + bsdf("diffuse", "") + "</bsdf>" + with_sensor("") + shape("<ref id=\"a\"/>"));
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0].text, "bsdf 'twosided': a <ref> leads to what is within, none to it");
}

TEST_F(Unread, WhatHasNoEffectIsListed) {
    const auto scene = load(R"(<default name="n" value="1"/>
<integrator type="volpath"><string name="anything" value="x"/></integrator>
<sensor type="perspective"><float name="near_clip" value="1"/>
<sampler type="multijitter"><integer name="sample_count" value="4"/></sampler></sensor>
<sensor type="perspective"/>
<bsdf type="diffuse" id="nobody"/>)");
    std::vector<std::string> texts;
    for (const Note& note : scene.notes) texts.push_back(std::to_string(note.place.line) + " " + note.text);
    EXPECT_EQ(texts, (std::vector<std::string>{"3 integrator 'volpath'", "5 sampler 'multijitter'",
                                               "4 'near_clip' of perspective", "6 another sensor",
                                               "7 bsdf 'diffuse': no <ref> to 'nobody'",
                                               "2 the default of $n, for which nothing asks"}));
    for (const Note& note : scene.notes) EXPECT_EQ(note.kind, Note::Kind::ignored);
}

TEST_F(Unread, LenientLeavesOutWhatNobodyReads) {
    const auto scene = load(R"(<shape type="sphere"><string name="colour" value="red"/><rgb value="1"/>
<transform name="to_world" x="1"/><flaot name="radius" value="2"/></shape><medium type="fog"/><bsdf type="plastic"/>)",
                            {.lenient = true});
    std::vector<std::string> texts;
    for (const Note& note : scene.notes) texts.push_back(note.text);
    EXPECT_EQ(texts, (std::vector<std::string>{
                         "'radius' of sphere by its absence", "'colour' of sphere by its absence",
                         "<rgb> of sphere by its absence", "the attribute 'x' of <transform> by its absence",
                         "<medium> of <scene> by its absence", "bsdf 'plastic' by its absence", texts.back()}));
    EXPECT_EQ(std::get<description::Sphere>(scene.shapes.at(0).geometry).radius, 1);
}

TEST_F(Unread, LenientTakesAConstantSkyForTheSun) {
    const std::string sunsky =
        "<emitter type=\"sunsky\"><float name=\"turbidity\" value=\"3\"/></emitter>" + with_sensor("");
    EXPECT_EQ(says(sunsky), "scene.xml:2: unknown emitter 'sunsky'; there are area, constant, envmap, point");
    const auto scene = load(sunsky, {.lenient = true});
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0].text, "emitter 'sunsky' by a constant sky of radiance 1");
    EXPECT_EQ(std::get<description::ConstantSky>(scene.emitters.at(0).kind).radiance, Spectrum::grey(1));
}

}  // namespace
}  // namespace plumb
