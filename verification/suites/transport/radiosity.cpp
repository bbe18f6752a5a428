// Path tracing against radiosity: light of all orders between two plates and within a closed box, by an integral
// equation that is solved without chance.

#include <map>
#include <mutex>

#include "analytic/radiosity_cases.h"
#include "integrators/estimators/path.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

using Plates = std::vector<RadiosityPlate>;

const Radiosity& solution(const RadiosityCase& subject) {
    static std::map<std::string, Radiosity> solved;  // some take a second
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    return solved.try_emplace(subject.id, subject.plates, 8).first->second;
}

Scene scene_of(const Plates& plates, const PlatePoint& seen) {
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

struct RenderedPlates {
    Plates plates;
    PathLimits limits = {};
};

/// The points of what is rendered, against the radiosity of the subject.
Verdict is_radiosity(const RadiosityCase& subject, const RenderedPlates& rendered, const Run& run) {
    const PathTracer tracer(rendered.limits);
    std::vector<Verdict> parts;
    for (const PlatePoint& seen : subject.points) {
        const Scene scene = scene_of(rendered.plates, seen);
        const Measurement measurement{scene, tracer, Point<2>{0.5, 0.5}, {}, 16, last_vertex};
        const double truth = solution(subject).radiance(seen.plate, seen.s, seen.t);
        // Floats of the camera's ray move the point by 1e-7, and with it the radiance.
        parts.push_back(
            mean_is([&](RandomStream& random) { return luminance(measurement.draw(random)); },
                    {.reference = truth,
                     .delta = run.pick(5e-3, 1e-3) * truth,
                     .epsilon = (subject.error + 1e-6) * truth,
                     .why_fewer = "sixteen paths between plates that see each other",
                     .cap = run.pick(std::uint64_t{1} << 19, std::uint64_t{1} << 23)},
                    run.part(fmt::format("point {}", parts.size()), 1 / static_cast<double>(subject.points.size()))));
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

void add(Catalogue& catalogue, const RadiosityCase& subject) {
    const auto check = [=](const RenderedPlates& rendered, const Run& run) {
        return is_radiosity(subject, rendered, run);
    };
    catalogue.add(
        {.id = "render/path/" + subject.id,
         .statement = subject.title + ", light of all orders is the radiosity of its integral equation.",
         .source = "ours, analytic/radiosity.h; [Lambert 1760] for its form factors",
         .kind = Kind::mean,
         .trial = {check,
                   {subject.plates},
                   {{"ends-early", "Paths end behind 3 edges.", {subject.plates, {.max_edges = 3}}},
                    {"albedo-squared",
                     "What one plate reflects is dimmed by its albedo twice.",
                     {with_squared_albedo(subject.plates)}},
                    {"brighter-walls", "Every plate reflects 1 % more.", {with_brighter_walls(subject.plates)}}}}});
}

}  // namespace

void add_transport_radiosity(Catalogue& catalogue) {
    for (const RadiosityCase& subject : radiosity_cases()) add(catalogue, subject);
}

}  // namespace plumb::suites
