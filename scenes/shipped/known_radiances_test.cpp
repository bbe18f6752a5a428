#include "scenes/shipped/known_radiances.h"

#include <numbers>

#include "analytic/irradiance.h"
#include "scenes/geometry/embree_scene.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/sensors/thin_lens.h"
#include "scenes/shipped/shipped.h"
#include "scenes/test_files.h"

namespace plumb {
namespace {

using description::ConstantSky;
using description::Disk;
using description::Emitter;
using description::Scene;
using description::Shape;
using description::Sphere;

double fov_x_of(const Scene& scene) {
    return std::visit([](const auto& camera) { return camera.fov_x; }, scene.sensor.value().kind);
}

/// A shipped scene in front of its camera.
struct Loaded {
    explicit Loaded(const std::string& name)
        : scene(load_mitsuba(scene_file(name))),
          known(known_radiances(scene_file(name).parent_path() / "expected.json")),
          embree(scene.shapes),
          plane(known.film, fov_x_of(scene), FovAxis::x) {}

    [[nodiscard]] Ray ray(const Point<2>& film) const {
        const Vec3 place = plane.place(film);
        return {scene.sensor->to_world.point({}),
                normalize(scene.sensor->to_world.vector({-place.x, place.y, place.z}))};
    }
    /// What a path of one edge brings: the light, or the sky, that the ray meets.
    [[nodiscard]] Spectrum emission(const Ray& ray) const {
        if (const auto hit = embree.intersect(rounded_ray(ray.origin, ray.direction))) {
            const auto& emitter = scene.shapes[hit->shape].emitter;
            const bool outside = dot(hit->point.normal, ray.direction) < 0;
            return emitter && outside ? emitter->radiance : Spectrum{};
        }
        Spectrum sky;
        for (const Emitter& emitter : scene.emitters)
            if (const auto* constant = std::get_if<ConstantSky>(&emitter.kind)) sky += constant->radiance;
        return sky;
    }

    Scene scene;
    KnownScene known;
    EmbreeScene embree;
    FilmPlane plane;
};

void expect_equal(const Spectrum& found, const KnownRadiance& known, double rounding, const std::string& where) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], known.value[i], known.error + rounding) << where << ": " << known.derivation;
}

/// Every radiance of one edge, where neither a mask nor a picture of the sky has a say, and every light of a black
/// surface.
TEST(KnownRadiances, ShowTheLightsThatTheCameraSees) {
    int checked = 0;
    for (const ShippedScene& shipped : shipped_scenes()) {
        const Loaded loaded(shipped.name);
        if (std::holds_alternative<description::ThinLens>(loaded.scene.sensor->kind)) continue;
        for (const KnownRadiance& known : loaded.known.radiances) {
            const bool light = known.derivation.find("seen directly") != std::string::npos;
            if ((known.edges != 1 && !light) || known.derivation.find(" map ") != std::string::npos ||
                known.derivation.find("gauze") != std::string::npos)
                continue;
            ++checked;
            expect_equal(loaded.emission(loaded.ray(known.film)), known, 0, shipped.name);
        }
    }
    EXPECT_GE(checked, 20);
}

/// What the lens sees: the mean over a grid of its points, and of four by four points of a pixel.
TEST(KnownRadiances, OfTheLensAreMeansOverIt) {
    const Loaded loaded("lens_focus");
    const Transform& to_world = loaded.scene.sensor->to_world;
    const CameraPose pose{to_world.point({}), to_world.vector({-1, 0, 0}), to_world.vector({0, 1, 0}),
                          to_world.vector({0, 0, 1})};
    const auto& asked = std::get<description::ThinLens>(loaded.scene.sensor->kind);
    const ThinLens lens(pose, loaded.known.film, asked.fov_x, asked.aperture_radius, asked.focus_distance);
    for (const KnownRadiance& known : loaded.known.radiances) {
        const int side = known.over == KnownRadiance::Over::pixel ? 4 : 1, points = 256 / side;
        Spectrum sum;
        for (int i = 0; i < points * points * side * side; ++i) {
            const int cell = i / (points * points), at = i % (points * points);
            const Point<2> film = side == 1 ? known.film
                                            : Point<2>{std::floor(known.film[0]) + (cell % side + 0.5) / side,
                                                       std::floor(known.film[1]) + (cell / side + 0.5) / side};
            sum += loaded.emission(lens.sample_ray(film, {(at % points + 0.5) / points, (at / points + 0.5) / points}));
        }
        // An edge crosses a few hundred of 256 by 256 cells, each of which is wrong by a half at most, either way.
        expect_equal(sum / (points * points * side * side), known, side == 1 ? 1e-3 : 1e-12, "lens_focus");
    }
}

/// The irradiance at a point of a floor that faces up.
using Irradiance = std::function<Spectrum(Vec3)>;

Irradiance irradiance_of(const Scene& scene) {
    constexpr Vec3 up{0, 1, 0};
    if (!scene.emitters.empty()) {
        return [light = std::get<description::PointLight>(scene.emitters.at(0).kind)](Vec3 p) {
            const Vec3 way = light.position - p;
            return light.intensity * (way.y / std::pow(length_squared(way), 1.5));
        };
    }
    const Shape& light = scene.shapes.at(1);
    const Spectrum radiance = light.emitter.value().radiance;
    if (const auto* sphere = std::get_if<Sphere>(&light.geometry))
        return [=, s = *sphere](Vec3 p) { return radiance * sphere_irradiance(p, up, s.center, s.radius); };
    if (const auto* disk = std::get_if<Disk>(&light.geometry))
        return
            [=, d = *disk](Vec3 p) { return radiance * disk_irradiance(p, up, d.center, d.normal, length(d.axis_x)); };
    // The triangles of a polygon, one by one: their common edges cancel.
    return [=, mesh = std::get<Mesh>(light.geometry)](Vec3 p) {
        double sum = 0;
        for (const auto& t : mesh.triangles)
            sum += polygon_irradiance(p, up, {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
        return radiance * sum;
    };
}

/// The mean over a pixel by the midpoint rule on n × n points and on twice as many, extrapolated [Richardson 1911].
Spectrum pixel_mean(const std::function<Spectrum(Point<2>)>& radiance, const Point<2>& film) {
    const auto midpoints = [&](int n) {
        Spectrum sum;
        for (int i = 0; i < n * n; ++i) {
            sum += radiance({std::floor(film[0]) + (i % n + 0.5) / n, std::floor(film[1]) + (i / n + 0.5) / n});
        }
        return sum / (n * n);
    };
    return (midpoints(32) * 4 - midpoints(16)) / 3;
}

TEST(KnownRadiances, AreThoseOfTheClosedForms) {
    for (const std::string name : {"disk_light", "point_light", "polygon_light", "quad_light", "sphere_light"}) {
        const Loaded loaded(name);
        const Irradiance irradiance = irradiance_of(loaded.scene);
        const auto radiance = [&](const Point<2>& film) {
            const Ray ray = loaded.ray(film);
            const Vec3 p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
            return irradiance({p.x, 0, p.z}) * (0.5 / std::numbers::pi);
        };
        for (const KnownRadiance& known : loaded.known.radiances) {
            if (known.edges != 2) continue;
            const auto hit =
                loaded.embree.intersect(rounded_ray(loaded.ray(known.film).origin, loaded.ray(known.film).direction));
            EXPECT_TRUE(hit && hit->shape == 0) << name << ": not the floor";
            const bool is_point = known.over == KnownRadiance::Over::point;
            // The camera's axes come from a matrix that is rounded; the midpoints' error falls by 1/16.
            expect_equal(is_point ? radiance(known.film) : pixel_mean(radiance, known.film), known,
                         is_point ? 1e-12 : 1e-8, name);
        }
    }
}

class KnownRadianceFiles : public testing_files::Folder {
protected:
    std::string says(const std::string& text) const {
        return message([&] { return known_radiances(write("e.json", text)); });
    }
    std::string says_of(const std::string& radiance) const {
        return says(R"({"question": "?", "film": [4, 3], "radiances": [)" + radiance + "]}");
    }
};

TEST_F(KnownRadianceFiles, AreRead) {
    const KnownScene scene = known_radiances(write("e.json", R"({"question": "Is it?", "film": [4, 3], "radiances": [
        {"film": [4, 1.5], "over": "pixel", "edges": null, "value": [1, 2, 3], "error": 1e-9, "derivation": "so"}]})"));
    EXPECT_EQ(scene.question, "Is it?");
    EXPECT_EQ(scene.film.height, 3);
    const KnownRadiance& known = scene.radiances.at(0);
    EXPECT_EQ(known.film, (Point<2>{4, 1.5}));
    EXPECT_EQ(known.over, KnownRadiance::Over::pixel);
    EXPECT_FALSE(known.edges);
    EXPECT_EQ(known.value, Spectrum::rgb(1, 2, 3));
    EXPECT_EQ(known.error, 1e-9);
}

TEST_F(KnownRadianceFiles, MaySpeakOfParts) {
    const auto box = [&](const std::string& place) {
        const KnownScene scene = known_radiances(
            write("e.json", R"({"question": "?", "film": [4, 3], "radiances": [{)" + place +
                                R"(, "edges": 1, "value": [1, 1, 1], "error": 0, "derivation": ""}]})"));
        const FilmBox found = scene.radiances.at(0).box;
        return std::vector{found.x, found.y, found.width, found.height};
    };
    EXPECT_EQ(box(R"("over": "film")"), (std::vector<double>{0, 0, 4, 3}));
    EXPECT_EQ(box(R"("over": "film", "film": [1, 1])"), (std::vector<double>{0, 0, 4, 3}));
    EXPECT_EQ(box(R"("over": "rectangle", "rectangle": [1.5, 0, 2, 2.5])"), (std::vector<double>{1.5, 0, 2, 2.5}));
    EXPECT_EQ(box(R"("over": "pixel", "film": [2.5, 1])"), (std::vector<double>{2, 1, 1, 1}));
    EXPECT_EQ(box(R"("over": "pixel", "film": [4, 3])"), (std::vector<double>{3, 2, 1, 1}));
    EXPECT_EQ(box(R"("over": "point", "film": [2.5, 1])"), (std::vector<double>{0, 0, 0, 0}));
}

TEST_F(KnownRadianceFiles, ThatAreWrongGetOneLine) {
    EXPECT_EQ(says("{\n]"), "e.json:2: malformed JSON");
    EXPECT_EQ(says("[]"), "e.json: [] where an object is expected");
    EXPECT_EQ(says("{\"film\": [4, 3], \"radiances\": []}"), "e.json: 'question' is missing");
    EXPECT_EQ(says(R"({"question": 1, "film": [4, 3], "radiances": []})"),
              "e.json: question: 1 where text is expected");
    EXPECT_EQ(says(R"({"question": "", "film": [4, 0], "radiances": []})"),
              "e.json: film[1]: 0 where a number from 1 to 65536 is expected");
    EXPECT_EQ(says(R"({"question": "", "film": [4, 3], "radiance": []})"),
              "e.json: unknown field 'radiance'; did you mean 'radiances'?");
    const std::string rest = R"(, "value": [1, 1, 1], "error": 0, "derivation": ""})";
    EXPECT_EQ(says_of(R"({"film": [1, 1], "over": "point")" + rest), "e.json: radiances[0]: 'edges' is missing");
    EXPECT_EQ(says_of(R"({"film": [5, 1], "over": "point", "edges": 1)" + rest),
              "e.json: radiances[0].film[0]: 5 where a number from 0 to 4 is expected");
    EXPECT_EQ(says_of(R"({"film": [1, 1], "over": "all", "edges": 1)" + rest),
              "e.json: radiances[0].over: \"all\" where \"point\", \"pixel\", \"rectangle\" or \"film\" is expected");
    EXPECT_EQ(says_of(R"({"film": [1, 1], "over": "point", "edges": 1.5)" + rest),
              "e.json: radiances[0].edges: 1.5 where a whole number is expected");
    EXPECT_EQ(says_of(R"({"film": [1, 1], "over": "point", "edges": 1, "value": [1], "error": 0, "derivation": ""})"),
              "e.json: radiances[0].value: [1] where a list of 3 is expected");
    const std::string whole = R"(, "edges": 1)" + rest;
    EXPECT_EQ(says_of(R"({"over": "point")" + whole), "e.json: radiances[0]: 'film' is missing");
    EXPECT_EQ(says_of(R"({"over": "rectangle")" + whole), "e.json: radiances[0]: 'rectangle' is missing");
    EXPECT_EQ(says_of(R"({"over": "rectangle", "rectangle": [1, 1, 4, 1])" + whole),
              "e.json: radiances[0].rectangle[2]: 4 where a number from 0 to 3 is expected");
    EXPECT_EQ(says_of(R"({"over": "rectangle", "rectangle": [1, 1, 0, 1])" + whole),
              "e.json: radiances[0].rectangle: [1,1,0,1] where a rectangle of some size is expected");
    EXPECT_EQ(says_of(R"({"over": "rectangle", "rectangle": [1, 1, 1, 1], "film": [1, 1])" + whole),
              "e.json: radiances[0].film: a rectangle lies where 'rectangle' says");
    EXPECT_EQ(says_of(R"({"over": "film", "rectangle": [1, 1, 1, 1])" + whole),
              "e.json: radiances[0].rectangle: is only for what is known over a \"rectangle\"");
    EXPECT_EQ(message([&] { return known_radiances(path_ / "none.json"); }).find("none.json"), 0u);
}

}  // namespace
}  // namespace plumb
