// These claims say how fast the error of the renderer's direct light falls with the samples of a pass, by its own
// samplers: through a fixed film point the light's two dimensions are all there is; in a pixel those of the film
// multiply them.

#include <boost/math/quadrature/gauss.hpp>

#include "analytic/irradiance.h"
#include "integrators/drivers/sampler.h"
#include "verification/claim.h"
#include "verification/evidence/rate.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

constexpr double edge = 0.15, slope = 0.3;  // of the blocker
constexpr double side = 0.5;                // of what the film shows of the floor
/// The height of the light: so far off that the edge matters more than the cosines, which would add a term of order
/// n^-2.
constexpr double height = 3;

/// The film shows the floor [-¼, ¼]² from straight above; a light over it, of which everything beyond the line
/// x = 2 edge + slope (y + y_floor) − x_floor is hidden where there is a blocker at half its height. (An edge along the
/// strata would be an easier case.)
description::Scene floor_and_light(bool blocked) {
    description::Scene scene;
    add_receiver(scene, {}, {0, 0, 1}, add_material(scene), 4);
    const auto black = add_material(scene, description::Diffuse{Spectrum{}});
    add_polygon(scene, {{-1, -1, height}, {-1, 1, height}, {1, 1, height}, {1, -1, height}}, black, Spectrum::grey(1));
    const auto blocker = [](double x, double y) { return Vec3{x + slope * y, y, height / 2}; };
    if (blocked) add_polygon(scene, {blocker(edge, -4), blocker(edge, 4), blocker(4, 4), blocker(4, -4)}, black);
    scene.sensor = camera({0, 0, side / 2}, {}, 90);
    return scene;
}

double radiance(Vec3 place, bool blocked) {
    const auto right = [&](double y) { return blocked ? 2 * edge + slope * (y + place.y) - place.x : 1; };
    return polygon_irradiance(place, {0, 0, 1},
                              {{-1, -1, height}, {-1, 1, height}, {right(1), 1, height}, {right(-1), -1, height}}) /
           pi;
}

struct Subject {
    bool blocked, pixel;  ///< over the whole pixel, or at a point of it
    std::string sampler;
};

/// The error of a pass of n samples, at a random film point so that an edge's place between the strata averages out.
Replicate error_of(const Subject& subject) {
    const auto scene = std::make_shared<Scene>(floor_and_light(subject.blocked));
    using boost::math::quadrature::gauss;
    const double mean = !subject.pixel ? 0
                                       : gauss<double, 15>::integrate(
                                             [&](double x) {
                                                 return gauss<double, 15>::integrate(
                                                     [&](double y) {
                                                         return radiance({x, y, 0}, subject.blocked);
                                                     },
                                                     -side / 2, side / 2);
                                             },
                                             -side / 2, side / 2) /
                                             (side * side);
    return [=](std::uint64_t n, RandomStream& random) {
        const double x = random.uniform();
        const Point<2> film{x, random.uniform()};
        const std::uint64_t seed = random.bits();
        Sampler sampler(subject.sampler, static_cast<std::uint32_t>(n));
        const Direct direct(lights_alone);
        PathRecord record;
        double sum = 0, truth = mean;
        for (std::uint32_t i = 0; i < n; ++i) {
            PrimarySamples& samples = sampler.start({seed, 0, i});
            AtFilmPoint at_point(*scene, film, samples);
            direct.trace(*scene, {}, subject.pixel ? samples : at_point, record);
            sum += record.sum()[0];
            if (!subject.pixel) truth = radiance(record.vertices.front().hit.point.position, subject.blocked);
        }
        return Estimate{sum / static_cast<double>(n) - truth, HUGE_VAL, n};
    };
}

Verdict converges(const Subject& subject, const std::vector<std::uint64_t>& n, const Interval& exponents,
                  const Run& run) {
    const std::string what = subject.pixel ? "pixel" : subject.blocked ? "light with an edge" : "light in full sight";
    return rate_is(error_of(subject), {subject.sampler, what, 0, n, run.pick<std::uint64_t>(1'200, 12'000)}, exponents,
                   run);
}

struct RateClaim {
    std::string id, statement, source;
    Subject subject;
    std::vector<std::uint64_t> n;
    Interval exponents;
    std::string mutant, defect;
    Subject worse;
};

}  // namespace

void add_direct_rates(Catalogue& catalogue) {
    const std::vector<std::uint64_t> squares{16, 64, 256}, powers{16, 32, 64, 128};
    const std::string fixed = "Through a film point, {} samples of a light {}: the MSE falls as n^{}.";
    const Subject smooth{false, false, "independent"}, hard{true, false, "independent"};
    const auto by = [](Subject subject, const std::string& sampler) {
        subject.sampler = sampler;
        return subject;
    };
    const std::string independent = "Independent samples: n^-1.";
    for (const RateClaim& c : std::vector<RateClaim>{
             {"stratified-smooth",
              fmt::format(fmt::runtime(fixed), "stratified", "in full sight", "-2"),
              "[Haber 1966]; docs/statistics.md",
              by(smooth, "stratified"),
              squares,
              {-2.3, -1.7},
              "independent",
              independent,
              smooth},
             {"stratified-edge",
              fmt::format(fmt::runtime(fixed), "stratified", "behind an edge", "-1.5"),
              "docs/statistics.md",
              by(hard, "stratified"),
              squares,
              {-1.75, -1.25},
              "independent",
              independent,
              hard},
             {"sobol-smooth",
              fmt::format(fmt::runtime(fixed), "Owen-scrambled", "in full sight", "-3 log n"),
              "[Owen 1997]",
              by(smooth, "sobol"),
              powers,
              {-3.3, -2.35},
              "stratified",
              "Stratified samples: n^-2.",
              by(smooth, "stratified")},
             {"sobol-edge",
              fmt::format(fmt::runtime(fixed), "Owen-scrambled", "behind an edge", "-1.5"),
              "docs/statistics.md",
              by(hard, "sobol"),
              powers,
              {-1.75, -1.25},
              "independent",
              independent,
              hard},
             {"pixel",
              "In a pixel with antialiasing the MSE of Owen-scrambled samples of a light falls as n^-1.",
              "docs/statistics.md",
              {true, true, "sobol"},
              {32, 64, 128, 256},
              {-1.2, -0.8},
              "without-antialiasing",
              "All samples go through one film point: n^-1.5.",
              by(hard, "sobol")}})
        catalogue.add({.id = "direct/rate/" + c.id,
                       .statement = c.statement,
                       .source = c.source,
                       .kind = Kind::rate,
                       .trial = {[=](const Subject& subject, const Run& run) {
                                     return converges(subject, c.n, c.exponents, run);
                                 },
                                 c.subject,
                                 {{c.mutant, c.defect, c.worse}}}});
}

}  // namespace plumb::suites
