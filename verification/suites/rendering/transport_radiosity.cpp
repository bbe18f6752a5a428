// Path tracing against radiosity: light of all orders between two plates and within a closed box, by an integral
// equation that is solved without chance.

#include "analytic/radiosity.h"
#include "integrators/path.h"
#include "verification/mean.h"
#include "verification/suites/rendering/direct_subjects.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

using Plates = std::vector<RadiosityPlate>;

/// A point of a plate that a camera looks at.
struct Seen {
    std::size_t plate;
    double s, t;
};

struct Subject {
    std::string id, title;
    Plates plates;
    const Radiosity& (*solution)();
    std::vector<Seen> seen;
    double error;  ///< of the solution, relative: what a larger n changes (analytic/radiosity_test.cpp)
};

template <Plates (*plates)()>
const Radiosity& solved() {
    static const Radiosity radiosity(plates(), 8);
    return radiosity;
}

/// Unit squares at half their side's distance, the upper of which shines.
Plates two_plates() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 0.8}, {{0, 0, 0.5}, {0, 1, 0}, {1, 0, 0}, 1, 0.6}};
}

/// A cube from inside, whose ceiling shines: floor, ceiling, walls.
Plates box(const std::array<double, 6>& albedos) {
    Plates faces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 0}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 1, 0},
                 {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 0}, {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0, 0},
                 {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0}, {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0, 0}};
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i].albedo = albedos[i];
    return faces;
}
Plates even_box() {
    return box({0.5, 0.5, 0.5, 0.5, 0.5, 0.5});
}
Plates uneven_box() {
    return box({0.6, 0.3, 0.7, 0.4, 0.5, 0.5});
}

std::vector<Subject> subjects() {
    return {
        {"two-plates", "Between two plates", two_plates(), solved<two_plates>, {{0, 0.1, 0.3}, {1, 0.2, 0.4}}, 1e-7},
        {"closed-box", "In a closed box of albedo ½", even_box(), solved<even_box>, {{2, 0.6, 0.4}}, 2e-5},
        {"uneven-box",
         "In a closed box of different albedos",
         uneven_box(),
         solved<uneven_box>,
         {{0, 0.3, 0.4}, {3, 0.5, 0.5}},
         2e-5}};
}

Scene scene_of(const Plates& plates, const Seen& seen) {
    description::Scene scene;
    for (const RadiosityPlate& plate : plates)
        add_polygon(scene, {plate.point(0, 0), plate.point(1, 0), plate.point(1, 1), plate.point(0, 1)},
                    add_material(scene, description::Diffuse{Spectrum::grey(plate.albedo)}),
                    plate.emission > 0 ? std::optional(Spectrum::grey(plate.emission)) : std::nullopt);
    const RadiosityPlate& plate = plates[seen.plate];
    const Vec3 point = plate.point(seen.s, seen.t);
    scene.sensor = camera(point + 0.2 * plate.normal() + 0.1 * plate.edge_1, point);
    return Scene(std::move(scene));
}

/// The points of `rendered`, against the radiosity of the subject.
Verdict is_radiosity(const Subject& subject, const Plates& rendered, const PathLimits& limits, const Run& run) {
    const PathTracer tracer(limits);
    std::vector<Verdict> parts;
    for (const Seen& seen : subject.seen) {
        const Scene scene = scene_of(rendered, seen);
        const Measurement measurement{scene, tracer, Point<2>{0.5, 0.5}, {}, 16, last_vertex};
        const double truth = subject.solution().radiance(seen.plate, seen.s, seen.t);
        // Floats of the camera's ray move the point by 1e-7, and with it the radiance.
        parts.push_back(
            mean_is([&](RandomStream& random) { return luminance(measurement.draw(random)); },
                    {.reference = truth,
                     .delta = run.pick(5e-3, 1e-3) * truth,
                     .epsilon = (subject.error + 1e-6) * truth,
                     .cap = run.pick(std::uint64_t{1} << 19, std::uint64_t{1} << 23)},
                    run.part(fmt::format("point {}", parts.size()), 1 / static_cast<double>(subject.seen.size()))));
        if (parts.back().outcome == Outcome::refuted) break;  // so is the whole
    }
    return all_of(std::move(parts));
}

Plates with_squared_albedo(Plates plates) {
    plates.front().albedo *= plates.front().albedo;
    return plates;
}

Plates with_brighter_walls(Plates plates) {
    for (RadiosityPlate& plate : plates) plate.albedo *= 1.01;
    return plates;
}

void add(Catalogue& catalogue, const Subject& subject) {
    const auto check = [=](const Plates& rendered, const PathLimits& limits) {
        return [=](const Run& run) { return is_radiosity(subject, rendered, limits, run); };
    };
    catalogue.add({.id = "render/path/" + subject.id,
                   .statement = subject.title + ", light of all orders is the radiosity of its integral equation.",
                   .source = "ours, analytic/radiosity.h; [Lambert 1760] for its form factors",
                   .kind = Kind::mean,
                   .check = check(subject.plates, {}),
                   .mutants = {{"ends-early", "Paths end behind 3 edges.", check(subject.plates, {.max_edges = 3})},
                               {"albedo-squared", "What one plate reflects is dimmed by its albedo twice.",
                                check(with_squared_albedo(subject.plates), {})},
                               {"brighter-walls", "Every plate reflects 1 % more.",
                                check(with_brighter_walls(subject.plates), {})}}});
}

}  // namespace

void add_transport_radiosity_claims(Catalogue& catalogue) {
    for (const Subject& subject : subjects()) add(catalogue, subject);
}

}  // namespace plumb
