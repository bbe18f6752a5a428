// Direct light of the renderer against closed forms, by each of its techniques: irradiance under polygons, spheres and
// disks, with and without something in between, and form factors of whole plates.

#include "analytic/irradiance.h"
#include "estimators/densities/warps.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

const Spectrum white = Spectrum::grey(1);
const Vec3 up{0, 0, 1};

/// What a white diffuse receiver sends on of a light of radiance 1.
struct Case {
    std::string name;
    std::shared_ptr<const Scene> scene;
    double radiance;
    FilmRegion region = {};
    std::optional<Point<2>> film = Point<2>{0.5, 0.5};
    bool touching = false;  ///< the light and the receiver: 1/d² has no variance there
};

/// A receiver at the origin and a camera that looks down on it from near by.
description::Scene lit_from(Vec3 normal) {
    description::Scene scene;
    add_receiver(scene, {}, normal, add_material(scene));
    scene.sensor = camera(0.1 * normal, {});
    return scene;
}

// ---- polygons

struct Polygon {
    std::string name;
    Vec3 normal;                                ///< of the receiver
    std::vector<Vec3> corners;                  ///< seen from the origin they turn counterclockwise
    std::vector<Vec3> blocker = {}, seen = {};  ///< what hides a part, and what is left
};

std::vector<Vec3> parallelogram(Vec3 corner, Vec3 e1, Vec3 e2) {
    return {corner, corner + e1, corner + e1 + e2, corner + e2};
}

std::vector<Vec3> hexagon(double height, double radius) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 6; ++i)
        corners.push_back({radius * std::cos(-pi * i / 3), radius * std::sin(-pi * i / 3), height});
    return corners;
}

std::vector<Polygon> polygons() {
    return {
        {"overhead", up, parallelogram({-0.75, -0.75, 1}, {0, 1.5, 0}, {1.5, 0, 0})},
        {"wide", up, parallelogram({-2, -2, 1}, {0, 4, 0}, {4, 0, 0})},
        {"aside", up, parallelogram({0.5, 0.25, 1}, {0, 1.5, 0}, {1.5, 0, 0})},
        {"a corner overhead", up, parallelogram({0, 0, 1}, {0, 2, 0}, {1.5, 0, 0})},
        {"a wall on the plane", up, parallelogram({1, -1.5, 0}, {0, 0, 2.5}, {0, 3, 0})},
        {"a wall half below the horizon", up, parallelogram({1, -1.5, -1}, {0, 0, 3.5}, {0, 3, 0})},
        {"tilted", up, parallelogram({-1, -1, 1}, {0, 2, 0}, {2, 0, 0.8})},
        {"a tube", up, parallelogram({-0.25, -3, 0.75}, {0, 6, 0}, {0.5, 0, 0})},
        {"a tilted receiver", normalize({1, 0, 1}), parallelogram({-0.5, -1, 1}, {0, 2, 0}, {1.5, 0, 0})},
        {"both tilted", normalize({0.4, -1, 1}), parallelogram({-2, -1, 0.9}, {0, 2, 0.3}, {3, 0, 0.2})},
        {"a hexagon", up, hexagon(1, 1)},
        {"half hidden", up, parallelogram({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}),
         parallelogram({0.125, -3, 0.5}, {0, 6, 0}, {3, 0, 0}),  // from the origin it hides what lies beyond x = ¼
         parallelogram({-1, -1, 1}, {0, 2, 0}, {1.25, 0, 0})},
    };
}

std::vector<Case> polygon_cases() {
    std::vector<Case> cases;
    for (const Polygon& polygon : polygons()) {
        description::Scene scene = lit_from(polygon.normal);
        const auto black = add_material(scene, description::Diffuse{Spectrum{}});
        add_polygon(scene, polygon.corners, black, white);
        if (!polygon.blocker.empty()) add_polygon(scene, polygon.blocker, black);
        cases.push_back(
            {polygon.name, std::make_shared<Scene>(std::move(scene)),
             polygon_irradiance({}, polygon.normal, polygon.seen.empty() ? polygon.corners : polygon.seen) / pi});
    }
    return cases;
}

// ---- spheres and disks

std::vector<Case> sphere_cases() {
    std::vector<Case> cases;
    for (const double height : {0.0, 0.5, 1.25})
        for (const double aside : {1.125, 1.5}) {
            const Vec3 centre{aside, 0.5, height};
            description::Scene scene = lit_from(up);
            description::Sphere sphere;
            sphere.center = centre;
            sphere.to_world = Transform::translate(centre);
            add_shape(scene, sphere, add_material(scene, description::Diffuse{Spectrum{}}), white);
            cases.push_back({fmt::format("height {} aside {}", height, aside),
                             std::make_shared<Scene>(std::move(scene)), sphere_irradiance({}, up, centre, 1) / pi});
        }
    return cases;
}

std::vector<Case> disk_cases() {
    struct Place {
        Vec3 receiver, centre, normal;
        double radius;
    };
    std::vector<Case> cases;
    for (const auto& [receiver, centre, normal, radius] :
         std::vector<Place>{{up, {0, 0, 1}, {0, 0, -1}, 1},
                            {up, {1, 0, 1}, {0, 0, -1}, 1},
                            {up, {0.4, 0.3, 1}, normalize({-0.5, 0, -1}), 1},
                            {up, {1, -0.5, 1}, {-1, 0, 0}, 1},
                            {normalize({1, 0, 2}), {0.5, 0, 1}, {0, 0, -1}, 0.8},
                            {normalize({-0.3, 0.4, 1}), {-0.5, 1, 1}, normalize({1, -1, -2}), 0.8}}) {
        description::Scene scene = lit_from(receiver);
        const Vec3 x = radius * perpendicular_to(normal);
        add_shape(scene, description::Disk{centre, x, cross(normal, x), normal},
                  add_material(scene, description::Diffuse{Spectrum{}}), white);
        cases.push_back({fmt::format("{}", cases.size()), std::make_shared<Scene>(std::move(scene)),
                         disk_irradiance({}, receiver, centre, normal, radius) / pi});
    }
    return cases;
}

// ---- form factors: the film shows a plate and nothing else

/// A floor [-w, w] × [-½, ½], seen from height w through a film of its shape: 90° across.
description::Scene floor_seen(int width) {
    description::Scene scene;
    const double w = width / 2.0;
    add_receiver(scene, {}, up, add_material(scene), 2 * w);
    description::Sensor sensor = camera({0, 0, w}, {}, 90, width, 1);
    sensor.to_world = Transform::look_at({0, 0, w}, {}, {0, 1, 0});
    scene.sensor = sensor;
    return scene;
}

std::vector<Case> form_factor_cases() {
    std::vector<Case> cases;
    const auto add = [&](const std::string& name, int width, const std::vector<Vec3>& light, double factor,
                         bool touching = false) {
        description::Scene scene = floor_seen(width);
        add_polygon(scene, light, add_material(scene, description::Diffuse{Spectrum{}}), white);
        cases.push_back({name, std::make_shared<Scene>(std::move(scene)), factor, {0, 0, width, 1}, {}, touching});
    };
    for (const double gap : {1.0, 1.5})
        add(fmt::format("unit squares at {}", gap), 1, parallelogram({-0.5, -0.5, gap}, {0, 1, 0}, {1, 0, 0}),
            parallel_rectangles_form_factor(1, 1, gap));
    add("2 × 1 plates at 1.25", 2, parallelogram({-1, -0.5, 1.25}, {0, 1, 0}, {2, 0, 0}),
        parallel_rectangles_form_factor(2, 1, 1.25));
    add("a wall of a cube", 1, parallelogram({0.5, -0.5, 0}, {0, 0, 1}, {0, 1, 0}),
        perpendicular_rectangles_form_factor(1, 1, 1), true);
    add("a long wall", 2, parallelogram({-1, 0.5, 0}, {2, 0, 0}, {0, 0, 1.5}),
        perpendicular_rectangles_form_factor(2, 1, 1.5), true);
    return cases;
}

// ---- the claims

struct Technique {
    std::string id, title;
    TechniqueCounts used;
    double delta;  ///< relative
    std::uint32_t n;
};
const std::vector<Technique>& techniques() {
    static const std::vector<Technique> list{{"emitters", "samples of lights", lights_alone, 5e-3, 16},
                                             {"bsdf", "samples of the BSDF", bsdf_alone, 2e-2, 32},
                                             {"mis", "both, weighted", one_of_each, 1e-2, 32}};
    return list;
}

Verdict is_closed_form(const std::vector<Case>& cases, const Technique& technique, const PathEstimator& estimator,
                       const Run& run) {
    std::vector<Verdict> parts;
    const double delta = run.pick(technique.delta, technique.delta / 4);
    for (const Case& c : cases) {
        if (c.touching && technique.used == lights_alone) continue;
        const Measurement measurement{*c.scene, estimator, c.film, c.region, technique.n};
        // Single precision of vertices and origins moves what is seen by less than 1e-6 of the distances, all near 1.
        parts.push_back(mean_is([&](RandomStream& random) { return measurement.draw(random)[0]; },
                                {.reference = c.radiance,
                                 .delta = delta * c.radiance,
                                 .epsilon = 1e-5 * c.radiance,
                                 .why_fewer = "one light that fills much of the view of 16 paths or more a draw"},
                                run.part(c.name, 1 / static_cast<double>(cases.size()))));
        if (parts.back().outcome == Outcome::refuted) break;  // so is the whole
    }
    return all_of(std::move(parts));
}

// ---- mutants

using Estimator = std::shared_ptr<const PathEstimator>;
using Defect = Wrong<Estimator>;

void drop_cosine(SceneLightSample& light, const SurfacePoint& from) {
    light.sample.radiance *= 1 / std::abs(dot(from.normal, light.sample.direction));
}
void take_per_area(SceneLightSample& light, const SurfacePoint&) {
    const LightSample& s = light.sample;
    light.pdf /= per_steradian(1, s.distance, std::abs(dot(s.surface->normal, s.direction)));
}

std::vector<Defect> light_defects() {
    return {{"cosine-dropped", "The cosine at the receiver is missing.",
             std::make_shared<Direct>(lights_alone, with_changed_lights(drop_cosine))},
            {"area-measure", "The density per area is used per steradian.",
             std::make_shared<Direct>(lights_alone, with_changed_lights(take_per_area))}};
}

std::vector<Defect> bsdf_defects() {
    std::vector<Defect> defects{{"another-density",
                                 "Directions are uniform, their weight is that of cosine-weighted ones.",
                                 std::make_shared<DirectBy>([](const Scene& scene, const PathVertex& vertex,
                                                               const Draws& of_vertex, PathRecord& record) {
                                     Vec3 local = sample_uniform_sphere(of_vertex.branch().at({1, Use::direction}));
                                     local.z = std::abs(local.z);
                                     const Vec3 wi = vertex.frame.to_world(local);
                                     const auto hit = scene.intersect(leave(vertex.hit.point, wi), 0, record.rays);
                                     return hit ? scene.emitted(*hit, -wi) : Spectrum{};
                                 })}};
    defects.push_back({"frame-of-the-world",
                       "The sample's direction is not turned from the shading frame into the world's.",
                       std::make_shared<DirectBy>([](const Scene& scene, const PathVertex& vertex,
                                                     const Draws& of_vertex, PathRecord& record) {
                           PathVertex other = vertex;
                           other.frame = Frame(up);
                           return gather_from_bsdf(scene, other, 1, with_counts({}, bsdf_alone), of_vertex, record);
                       })});
    return defects;
}

std::vector<Defect> mis_defects() {
    const NextEvent balance = with_weight(mis_weight<Balance>);
    return {{"squared-on-one-side", "The power heuristic for lights, the balance heuristic for BSDFs.",
             std::make_shared<DirectBy>(
                 [balance](const Scene& scene, const PathVertex& vertex, const Draws& of_vertex, PathRecord& record) {
                     return gather_from_lights(scene, vertex, 1, {}, of_vertex, record) +
                            gather_from_bsdf(scene, vertex, 1, balance, of_vertex, record);
                 })},
            {"counted-twice", "Both techniques count in full.", std::make_shared<Direct>(with_weight(in_full))}};
}

std::vector<Defect> defects_of(const Technique& technique) {
    std::vector<Defect> list = technique.used == lights_alone ? light_defects()
                               : technique.used == bsdf_alone ? bsdf_defects()
                                                              : mis_defects();
    list.push_back({"slightly-bright", fmt::format("{:.3g} % too bright.", 250 * technique.delta),
                    std::make_shared<Scaled>(std::make_shared<Direct>(technique.used), 1 + 2.5 * technique.delta)});
    return list;
}

struct Family {
    std::string id, statement, source;
    std::vector<Case> (*cases)();
    std::vector<std::string> left_out = {};  ///< mutants that change nothing here, or whose variance is infinite
};

void add_family(Catalogue& catalogue, const Family& family) {
    for (const Technique& technique : techniques()) {
        const auto check = [=](const Estimator& estimator, const Run& run) {
            return is_closed_form(family.cases(), technique, *estimator, run);
        };
        std::vector<Defect> defects = defects_of(technique);
        std::erase_if(defects, [&](const Defect& defect) {
            return std::ranges::find(family.left_out, defect.id) != family.left_out.end();
        });
        catalogue.add(
            {.id = fmt::format("direct/{}/{}", family.id, technique.id),
             .statement = fmt::format("The renderer's direct light, by {}, is {}.", technique.title, family.statement),
             .source = family.source,
             .kind = Kind::mean,
             .trial = {check, std::make_shared<Direct>(technique.used), std::move(defects)}});
    }
}

}  // namespace

void add_direct_closed_forms(Catalogue& catalogue) {
    add_family(catalogue, {"polygon", "Lambert's closed form under 12 polygons, one of them half hidden",
                           "[Lambert 1760]; analytic/irradiance.h", polygon_cases});
    add_family(catalogue, {"sphere",
                           "the closed form under 6 spheres, some partly below the horizon",
                           "[Snyder 1996]; analytic/irradiance.h",
                           sphere_cases,
                           {"area-measure", "frame-of-the-world"}});
    add_family(catalogue, {"disk", "the closed form under 6 disks", "ours, analytic/irradiance.cpp", disk_cases});
    add_family(catalogue,
               {"form-factor",
                "the form factor of two plates over a whole plate and, except for samples of lights, that of "
                "a box's walls",
                "[Howell, C-11, C-14]",
                form_factor_cases,
                {"counted-twice", "frame-of-the-world"}});
}

}  // namespace plumb::suites
