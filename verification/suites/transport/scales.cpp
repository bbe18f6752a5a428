// Light is linear: with all emission times 2^k every integrator makes the same picture times 2^k, to the bit, with the
// same relative error. And light knows no lengths: with all lengths times 2^k, and the intensity of what shines from a
// point times 4^k, it makes the same picture.

#include <fmt/format.h>

#include "integrators/drivers/render.h"
#include "integrators/integrators.h"
#include "scenes/film/film_error.h"
#include "verification/suites/direct/direct_subjects.h"
#include "verification/suites/suites.h"
#include "verification/suites/tally.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

/// Two lamps and a sky, with a point light.
description::Scene lamps(int k) {
    const double factor = std::ldexp(1.0, k);
    description::Scene scene = lamps_scene().description();
    for (description::Shape& shape : scene.shapes)
        if (shape.emitter) shape.emitter->radiance *= factor;
    scene.emitters.clear();
    scene.emitters.push_back({description::ConstantSky{Spectrum::grey(0.2 * factor)}, {}});
    scene.emitters.push_back({description::PointLight{{0, -0.5, 1.5}, Spectrum::grey(0.3 * factor)}, {}});
    return scene;
}

/// The same with all lengths times 2^k, and a ball among the lamps.
description::Scene lengths(int k) {
    const double factor = std::ldexp(1.0, k);
    const Transform scale = Transform::scale({factor, factor, factor});
    description::Scene scene = lamps(0);
    add_shape(scene,
              description::Sphere{.center = {0.4, -0.3, 0.7}, .radius = 0.2, .flip_normals = false, .to_world = {}},
              scene.shapes.front().material);
    for (description::Shape& shape : scene.shapes) {
        if (Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) *mesh = transformed(std::move(*mesh), scale);
        if (auto* ball = std::get_if<description::Sphere>(&shape.geometry)) {
            ball->center = ball->center * factor;
            ball->radius *= factor;
        }
    }
    for (description::Emitter& emitter : scene.emitters)
        if (auto* point = std::get_if<description::PointLight>(&emitter.kind)) {
            point->position = point->position * factor;
            point->intensity *= factor * factor;
        }
    scene.sensor->to_world = scale * scene.sensor->to_world;
    return scene;
}

description::Scene lengths_but_of_the_ball(int k) {
    description::Scene scene = lengths(k);
    std::get<description::Sphere>(scene.shapes.back().geometry).radius *= std::ldexp(1.0, -k);
    return scene;
}

/// A render of a job's passes.
using MakeFilm = Film (*)(const RenderJob& job);

Film rendered(const RenderJob& job) {
    return render(job).film;
}

/// The same with sums that resolve 2^-64 of radiance 1.
Film in_absolute_units(const RenderJob& job) {
    std::vector<FilmLayer> layers = render_layers(job);
    layers[0].exponent = 0;
    const FilmRegion& crop = job.settings.crop;
    Film film({crop.width, crop.height}, layers);
    for (std::uint32_t pass = 0; pass < job.settings.passes; ++pass) {
        PassImage image(crop, layers);
        for (std::size_t piece = 0; piece < job.driver->pieces(job); ++piece) job.driver->make(job, pass, piece, image);
        film.add(image.pixels());
    }
    return film;
}

void compare(const Film& one, const Film& other, int k, const std::string& name, Tally& tally) {
    for (int y = 0; y < one.size().height; ++y)
        for (int x = 0; x < one.size().width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const double mean = std::ldexp(one.mean(x, y, c), k), variance = one.variance_of_mean(x, y, c);
                tally.expect(other.mean(x, y, c) == mean, [&] {
                    return fmt::format("{}, k = {}: pixel ({}, {}) is {:.17g}, not {:.17g}", name, k, x, y,
                                       other.mean(x, y, c), mean);
                });
                tally.expect(other.variance_of_mean(x, y, c) == std::ldexp(variance, 2 * k), [&] {
                    return fmt::format("{}, k = {}: the variance of pixel ({}, {}) is {:.17g}, not {:.17g}", name, k, x,
                                       y, other.variance_of_mean(x, y, c), std::ldexp(variance, 2 * k));
                });
            }
    const double before = error_of(one).relative, after = error_of(other).relative;
    tally.expect(before == after, [&] {
        return fmt::format("{}, k = {}: the relative error is {:.17g}, not {:.17g}", name, k, after, before);
    });
    tally.expect(one.bad_values() == other.bad_values(),
                 [&] { return fmt::format("{}, k = {}: other values are bad", name, k); });
}

using MakeScene = description::Scene (*)(int k);

Film film_of(const NamedIntegrator& integrator, description::Scene description, MakeFilm make, const Run& run) {
    const PathLimits limits{.max_edges = integrator.makes.longest.value_or(4), .roulette_edges = 2};
    const auto estimator = integrator.make(limits, Parameters(integrator.parameters, {}));
    const Scene scene(std::move(description));
    return make(job_of(scene, *estimator,
                       {.samples_per_pass = 2, .passes = 4, .seed = run.random(0).bits(), .crop = {4, 4, 8, 8}}));
}

Verdict same_picture(const NamedIntegrator& integrator, MakeFilm make, const Run& run) {
    const Film one = film_of(integrator, lamps(0), make, run);
    Tally tally;
    for (const int k : run.pick(std::vector{-100, -37, 1, 100}, std::vector{-300, -100, -64, -37, -1, 1, 23, 100, 300}))
        compare(one, film_of(integrator, lamps(k), make, run), k, integrator.id, tally);
    return tally.verdict("values are the same times 2^k");
}

Verdict same_at_all_lengths(const NamedIntegrator& integrator, MakeScene scene, const Run& run) {
    const Film one = film_of(integrator, lengths(0), rendered, run);
    Tally tally;
    for (const int k : run.pick(std::vector{-20, 28}, std::vector{-20, -13, -1, 1, 17, 28})) {
        const Film other = film_of(integrator, scene(k), rendered, run);
        for (int y = 0; y < one.size().height; ++y)
            for (int x = 0; x < one.size().width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    tally.expect(other.mean(x, y, c) == one.mean(x, y, c), [&] {
                        return fmt::format("{}, k = {}: pixel ({}, {}) is {:.17g}, not {:.17g}", integrator.id, k, x, y,
                                           other.mean(x, y, c), one.mean(x, y, c));
                    });
    }
    return tally.verdict("values are the same");
}

}  // namespace

void add_transport_scales(Catalogue& catalogue) {
    for (const NamedIntegrator& integrator : integrators()) {
        if (!integrator.makes.radiance) continue;
        catalogue.add(
            {.id = fmt::format("render/{}/scale", integrator.id),
             .statement = fmt::format("With all emission times 2^k, k from -100 to 100, `{}` makes the same "
                                      "picture times 2^k, to the bit, with the same relative error.",
                                      integrator.id),
             .source = "ours, integrators/drivers/job.h",
             .kind = Kind::exact,
             .trial = {[&integrator](MakeFilm make, const Run& run) { return same_picture(integrator, make, run); },
                       MakeFilm(rendered),
                       {{"absolute-units", "Sums resolve a fixed part of radiance 1.", MakeFilm(in_absolute_units)}}}});
        catalogue.add(
            {.id = fmt::format("render/{}/lengths", integrator.id),
             .statement = fmt::format("With all lengths times 2^k, k from -20 to 28, and intensities times "
                                      "4^k, `{}` makes the same picture, to the bit.",
                                      integrator.id),
             .source = "ours, scenes/geometry/surface_point.h",
             .kind = Kind::exact,
             .trial = {
                 [&integrator](MakeScene scene, const Run& run) { return same_at_all_lengths(integrator, scene, run); },
                 MakeScene(lengths),
                 {{"ball-as-it-was", "The radius of a ball stays as it was.", MakeScene(lengths_but_of_the_ball)}}}});
    }
}

}  // namespace plumb::suites
