// These claims say how fast the error of direct light at a fixed shading point falls with the number of samples of one
// light: the pixel stays fixed, so the light's two dimensions are all there is.

#include "analytic/irradiance.h"
#include "estimators/points/mean_over.h"
#include "estimators/points/stratified.h"
#include "estimators/points/zero_two.h"
#include "scenes/emitters/rectangle_light.h"
#include "verification/claim.h"
#include "verification/evidence/rate.h"

namespace plumb::suites {
namespace {

using Generate = std::vector<Point<2>> (*)(std::uint64_t n, RandomStream& random);

const Vec3 corner{-0.3, -0.6, 1}, edge_1{0, 1.2, 0}, edge_2{1.5, 0, 0}, up{0, 0, 1};

/// An occluder hides the part of the light beyond the line t = a + 0.37 s, a random: a straight edge at a random place,
/// so that its place between the strata averages out. What is left is a polygon, hence the closed form.
struct Scene {
    double a;  ///< infinite: no occluder

    [[nodiscard]] bool sees(const Point<2>& u) const { return u[1] < a + 0.37 * u[0]; }
    [[nodiscard]] double irradiance() const {
        const auto place = [](double s, double t) { return corner + s * edge_1 + t * edge_2; };
        const double left = std::min(1.0, a), right = std::min(1.0, a + 0.37);
        return polygon_irradiance({}, up, {place(0, 0), place(1, 0), place(1, right), place(0, left)});
    }
};

Verdict converges(Generate points, bool edge, const std::vector<std::uint64_t>& n, const Interval& exponents,
                  const Run& run) {
    const RectangleLight light(corner, edge_1, edge_2, Spectrum::grey(1));
    const Replicate error = [&](std::uint64_t count, RandomStream& random) {
        const Scene scene{edge ? 0.2 + 0.3 * random.uniform() : HUGE_VAL};
        const auto f = [&](const Point<2>& u) {
            const auto sample = light.sample({}, u);
            return sample && scene.sees(u) ? sample->radiance[0] * sample->direction.z / sample->pdf : 0;
        };
        Estimate estimate = mean_over<2>(points(count, random), f);
        estimate.value -= scene.irradiance();
        return estimate;
    };
    return rate_is(error, {"light samples", edge ? "light with an edge" : "light in full sight", 0, n, 1500}, exponents,
                   run);
}

void add(Catalogue& catalogue, const std::string& id, const std::string& statement, const std::string& source,
         Generate points, bool edge, const std::vector<std::uint64_t>& n, const Interval& exponents,
         const Wrong<Generate>& worse) {
    catalogue.add(
        {.id = "light/rate/" + id,
         .statement = statement,
         .source = source,
         .kind = Kind::rate,
         .trial = {[=](Generate generate, const Run& run) { return converges(generate, edge, n, exponents, run); },
                   points,
                   {worse}}});
}

std::vector<Point<2>> anywhere_first(std::uint64_t n, RandomStream& random) {
    auto points = owen_zero_two(n, random);
    for (double& x : points[0]) x = random.uniform();
    return points;
}

}  // namespace

void add_lights_rates(Catalogue& catalogue) {
    const std::vector<std::uint64_t> squares{16, 64, 256}, powers{16, 32, 64, 128};
    const Wrong<Generate> independent{"independent", "Independent samples: n^-1.", independent_points<2>};
    add(catalogue, "jittered-smooth", "With jittered samples of a light in full sight the MSE falls as n^-2.",
        "[Haber 1966]; docs/statistics.md", stratified_2d, false, squares, {-2.3, -1.7}, independent);
    add(catalogue, "jittered-edge", "With jittered samples of a light behind an edge the MSE falls as n^-1.5.",
        "docs/statistics.md", stratified_2d, true, squares, {-1.7, -1.3}, independent);
    add(catalogue, "owen-smooth", "With Owen-scrambled samples of a light in full sight the MSE falls as n^-3 log n.",
        "[Owen 1997]", owen_zero_two, false, powers, {-3.25, -2.4},
        {"first-sample-anywhere", "The first sample is drawn anywhere, which adds a variance of order n^-2.",
         anywhere_first});
    add(catalogue, "owen-edge", "With Owen-scrambled samples of a light behind an edge the MSE falls as n^-1.5.",
        "docs/statistics.md", owen_zero_two, true, powers, {-1.75, -1.25}, independent);
}

}  // namespace plumb::suites
