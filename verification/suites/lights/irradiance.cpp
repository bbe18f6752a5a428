// Irradiance from lights with nothing in between, by light samples, against closed forms; and the choice among
// lights.

#include "analytic/irradiance.h"

#include "estimators/densities/warps.h"
#include "estimators/points/stratified.h"
#include "scenes/emitters/disk_light.h"
#include "scenes/emitters/light_chooser.h"
#include "scenes/emitters/mesh_light.h"
#include "scenes/emitters/rectangle_light.h"
#include "scenes/emitters/sphere_light.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

const Spectrum white = Spectrum::grey(1);

using SampleFrom = std::function<std::optional<LightSample>(Vec3 from, const Point<2>& u)>;
/// Changes a sample seen from a place: the defect of a mutant.
using Defect = std::function<void(LightSample&)>;

struct Placement {
    std::string name;
    Vec3 normal;  ///< of the receiver, which is the origin
    SampleFrom sample;
    double irradiance;
    double largest;  ///< of cos θ L / pdf
};

double contribution(const LightSample& sample, Vec3 normal) {
    return sample.radiance[0] * std::max(0.0, dot(normal, sample.direction)) / sample.pdf;
}

Verdict irradiance_is(const Placement& placement, const Defect& defect, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        double sum = 0;
        for (const Point<2>& u : stratified_2d(16, random))
            if (auto sample = placement.sample({}, u)) {
                if (defect) defect(*sample);
                sum += contribution(*sample, placement.normal);
            }
        return sum / 16;
    };
    return mean_is(draw,
                   {.reference = placement.irradiance,
                    .delta = 4e-3 * placement.irradiance,
                    .epsilon = 1e-12 * placement.irradiance,
                    .bounds = {0, placement.largest}},
                   run);
}

Verdict all_irradiances(const std::vector<Placement>& placements, const Defect& defect, const Run& run) {
    std::vector<Verdict> parts;
    for (const Placement& placement : placements)
        parts.push_back(
            irradiance_is(placement, defect, run.part(placement.name, 1 / static_cast<double>(placements.size()))));
    return all_of(std::move(parts));
}

/// cos θ cos θ' A/d² is at most A over the square of the distance to the nearest point, for which the plane's serves.
double largest_from_plane(double area, Vec3 point, Vec3 normal) {
    const double height = dot(normal, point);
    return area / (height * height);
}

struct Parallelogram {
    Vec3 normal, corner, edge_1, edge_2;
};
const std::vector<Parallelogram>& parallelograms() {
    static const Vec3 up{0, 0, 1};
    static const std::vector<Parallelogram> list{
        {up, {-0.5, -0.5, 1}, {0, 1, 0}, {1, 0, 0}},                         // overhead
        {up, {-2, -2, 1}, {0, 4, 0}, {4, 0, 0}},                             // wide
        {up, {1, 0.5, 2}, {0, 1, 0}, {1, 0, 0}},                             // aside
        {up, {0, 0, 1.5}, {0, 2, 0}, {1, 0, 0}},                             // corner overhead
        {up, {2, -1, 0}, {0, 0, 2}, {0, 2, 0}},                              // a wall that stands on the plane
        {up, {2, -1, -1}, {0, 0, 2}, {0, 2, 0}},                             // a wall, half below the horizon
        {up, {-1, -1, 1}, {0, 2, 0}, {2, 0, 0.8}},                           // tilted
        {up, {-0.1, -3, 1}, {0, 6, 0}, {0.2, 0, 0}},                         // a tube
        {up, {-1, -1, 2}, {1, 2, 0}, {2, 0, 0}},                             // oblique
        {normalize({1, 0, 1}), {-0.5, -0.5, 1.5}, {0, 1, 0}, {1, 0, 0}},     // tilted receiver
        {normalize({0.4, -1, 1}), {-2, -1, 1.2}, {0, 2, 0.3}, {3, 0, 0.2}},  // both, partly below the horizon
        {up, {20, 10, 9}, {0, 3, 0}, {3, 0, 0}},                             // far
    };
    return list;
}

std::vector<Placement> polygon_placements(bool as_mesh) {
    std::vector<Placement> placements;
    for (const auto& [normal, corner, e1, e2] : parallelograms()) {
        const Vec3 a = corner, b = corner + e1, c = corner + e1 + e2, d = corner + e2, product = cross(e1, e2);
        const Vec3 third = a + 0.3 * (c - a);  // the mesh's triangles differ in size
        SampleFrom sample = [light = RectangleLight(corner, e1, e2, white)](Vec3 from, const Point<2>& u) {
            return light.sample(from, u);
        };
        if (as_mesh)
            sample = [light = MeshLight({{a, b, third}, {b, c, third}, {c, d, third}, {d, a, third}}, white)](
                         Vec3 from, const Point<2>& u) { return light.sample(from, u); };
        placements.push_back({fmt::format("{}", placements.size()), normal, sample,
                              polygon_irradiance({}, normal, {a, b, c, d}),
                              largest_from_plane(length(product), corner, normalize(product))});
    }
    return placements;
}

std::vector<Placement> sphere_placements() {
    std::vector<Placement> placements;
    for (const double height : {-0.5, -0.2, 0.0, 0.5, 1.5, 4.0})
        for (const double aside : {1.1, 3.0}) {
            const Vec3 centre{aside, 0.5, height};
            const double d = length(centre), solid_angle = 2 * pi * (1 - std::sqrt(1 - 1 / (d * d)));
            placements.push_back({fmt::format("height {} aside {}", height, aside),
                                  {0, 0, 1},
                                  [light = SphereLight(centre, 1, white)](Vec3 from, const Point<2>& u) {
                                      return light.sample(from, u);
                                  },
                                  sphere_irradiance({}, {0, 0, 1}, centre, 1),
                                  solid_angle * (1 + 1e-12)});
        }
    return placements;
}

std::vector<Placement> disk_placements() {
    struct Place {
        Vec3 receiver, centre, normal;
    };
    std::vector<Placement> placements;
    for (const Place& place : std::vector<Place>{{{0, 0, 1}, {0, 0, 1}, {0, 0, -1}},
                                                 {{0, 0, 1}, {1.5, 0, 1}, {0, 0, -1}},
                                                 {{0, 0, 1}, {0.4, 0.3, 2}, normalize({-0.5, 0, -1})},
                                                 {{0, 0, 1}, {2, -1, 1}, {-1, 0, 0}},
                                                 {normalize({1, 0, 2}), {0.5, 0, 1.5}, {0, 0, -1}},
                                                 {normalize({-0.3, 0.4, 1}), {-1, 2, 2}, normalize({1, -1, -2})}})
        placements.push_back({fmt::format("{}", placements.size()), place.receiver,
                              [light = DiskLight(place.centre, place.normal, 0.8, white)](
                                  Vec3 from, const Point<2>& u) { return light.sample(from, u); },
                              disk_irradiance({}, place.receiver, place.centre, place.normal, 0.8),
                              largest_from_plane(pi * 0.64, place.centre, place.normal)});
    return placements;
}

void add_irradiance(Catalogue& catalogue, const std::string& name, const std::string& lights, std::size_t count,
                    const std::string& source, const std::function<std::vector<Placement>()>& placements,
                    std::vector<Wrong<Defect>> wrong) {
    const auto check = [=](const Defect& defect, const Run& run) { return all_irradiances(placements(), defect, run); };
    wrong.push_back({"one-percent", "The density is 1 % too small.", [](LightSample& s) { s.pdf *= 0.99; }});
    catalogue.add({.id = "light/" + name + "/irradiance",
                   .statement = fmt::format("Samples of {} give the irradiance of the closed form at {} placements.",
                                            lights, count),
                   .source = source,
                   .kind = Kind::mean,
                   .trial = {check, {}, std::move(wrong)}});
}

// ---- the choice among lights

Verdict chances_sum_to_one(const std::function<double(const LightChooser&, std::size_t)>& pmf) {
    std::vector<BoundedCase> cases;
    for (std::size_t n = 1; n <= 1000; n = n * 3 + 1) {
        std::vector<Spectrum> powers;
        for (std::size_t i = 0; i < n; ++i) powers.push_back(Spectrum::grey(static_cast<double>(i * i % 17)));
        if (n == 1) powers[0] = white;
        for (const LightChooser& chooser : {LightChooser::uniform(n), LightChooser::by_power(powers)}) {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) sum += pmf(chooser, i);
            cases.push_back({fmt::format("{} lights", n), std::abs(sum - 1), static_cast<double>(n)});
        }
    }
    return within_bound(cases, 1e-12, "of 1");
}

const LightChooser& four_lights() {
    static const LightChooser chooser =
        LightChooser::by_power({Spectrum::grey(1), Spectrum::grey(5), Spectrum::grey(0), Spectrum::grey(2)});
    return chooser;
}

Verdict choices_follow(const LightChooser& chooser, const Run& run) {
    return distribution_is([&](RandomStream& random) { return chooser.sample(random.uniform()).index; },
                           {{1.0 / 8, 5.0 / 8, 0, 2.0 / 8}, 0.03}, run);
}

/// One sample of one light, chosen by power, for a rectangle overhead and a disk aside.
Verdict chosen_sum_is(const std::function<double(const ChosenLight&)>& pmf, const Run& run) {
    const Vec3 up{0, 0, 1};
    const RectangleLight rectangle({-0.5, -0.5, 1}, {0, 1, 0}, {1, 0, 0}, white);
    const DiskLight disk({1.5, 0, 1}, {0, 0, -1}, 0.8, white);
    const LightChooser chooser = LightChooser::by_power({rectangle.power(1), disk.power(1)});
    const double reference =
        polygon_irradiance({}, up, {{-0.5, -0.5, 1}, {-0.5, 0.5, 1}, {0.5, 0.5, 1}, {0.5, -0.5, 1}}) +
        disk_irradiance({}, up, {1.5, 0, 1}, {0, 0, -1}, 0.8);
    const auto draw = [&](RandomStream& random) {
        const ChosenLight chosen = chooser.sample(random.uniform());
        const double u = random.uniform();
        const Point<2> place{u, random.uniform()};
        const auto sample = chosen.index == 0 ? rectangle.sample({}, place) : disk.sample({}, place);
        return sample ? contribution(*sample, up) / pmf(chosen) : 0;
    };
    // Either light's contribution is at most its area over its probability: the sum of both areas.
    return mean_is(draw, {.reference = reference, .delta = 0.01 * reference, .bounds = {0, 1 + pi * 0.64 + 1e-9}}, run);
}

void add_choice(Catalogue& catalogue) {
    const auto right = [](const LightChooser& chooser, std::size_t i) { return chooser.pmf(i); };
    catalogue.add({.id = "light/choice/sums-to-1",
                   .statement = "The probabilities of choosing lights, uniformly or by power, sum to 1.",
                   .source = "ours, scenes/emitters/light_chooser.h",
                   .kind = Kind::bounded,
                   .trial = {chances_sum_to_one,
                             right,
                             {{"without-the-last", "The last light is left out.",
                               [=](const LightChooser& chooser, std::size_t i) {
                                   return i + 1 == chooser.count() ? 0 : right(chooser, i);
                               }}}}});
    catalogue.add({.id = "light/choice/distribution",
                   .statement = "Lights are chosen in proportion to their power, black ones never.",
                   .source = "ours, scenes/emitters/light_chooser.h",
                   .kind = Kind::distribution,
                   .trial = {choices_follow,
                             four_lights(),
                             {{"uniform", "All alike.", LightChooser::uniform(4)},
                              {"power-off", "The first light has the power 1.25, not 1.",
                               LightChooser::by_power({Spectrum::grey(1.25), Spectrum::grey(5), Spectrum::grey(0),
                                                       Spectrum::grey(2)})}}}});
    catalogue.add(
        {.id = "light/choice/irradiance",
         .statement = "One sample of one light, over the product of both probabilities, gives the irradiance of all.",
         .source = "ours, scenes/emitters/light_chooser.h",
         .kind = Kind::mean,
         .trial = {
             chosen_sum_is,
             [](const ChosenLight& chosen) { return chosen.pmf; },
             {{"pmf-dropped", "The probability of the light is left out.", [](const ChosenLight&) { return 1.0; }},
              {"uniform-pmf", "The probability is one in two, however they are chosen.",
               [](const ChosenLight&) { return 0.5; }}}}});
}

}  // namespace

void add_lights_irradiance(Catalogue& catalogue) {
    const std::vector<Wrong<Defect>> planar{
        {"without-distance", "d² is missing in the density.", [](LightSample& s) { s.pdf /= s.distance * s.distance; }},
        {"cosine-squared", "The cosine at the receiver is squared.",
         [](LightSample& s) { s.radiance = s.radiance * std::abs(s.direction.z); }}};
    add_irradiance(
        catalogue, "rectangle", "a rectangle light", 12, "[Lambert 1760]; analytic/irradiance.h",
        [] { return polygon_placements(false); }, planar);
    add_irradiance(
        catalogue, "mesh", "a light of four triangles", 12, "[Lambert 1760]; analytic/irradiance.h",
        [] { return polygon_placements(true); }, planar);
    add_irradiance(catalogue, "sphere", "a sphere light, parts of it below the horizon,", 12,
                   "[Snyder 1996]; analytic/irradiance.h", sphere_placements,
                   {{"hemisphere", "The density is that of a cone of twice the solid angle.",
                     [](LightSample& s) { s.pdf /= 2; }}});
    add_irradiance(catalogue, "disk", "a disk light", 6, "ours, analytic/irradiance.cpp", disk_placements, planar);
    add_choice(catalogue);
}

}  // namespace plumb::suites
