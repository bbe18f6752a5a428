// Lights that are chosen seldom and bring much: a picture's stated error covers, or the render says that it does not
// know.

#include <fmt/format.h>

#include "integrators/drivers/render_until.h"
#include "verification/evidence/mean.h"
#include "verification/suites/suites.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

/// A lamp of 20 W/sr, 3 above a ground of this half width and albedo ½, under a sky of 0.1: the ground's radiance below
/// it is 0.1/2 from the sky and 1/2π · 20/9 from the lamp.
description::Scene lamp_under_sky(double ground) {
    description::Scene scene;
    const auto grey = add_material(scene, description::Diffuse{Spectrum::grey(0.5)});
    const double g = ground;
    add_polygon(scene, {{-g, -g, 0}, {g, -g, 0}, {g, g, 0}, {-g, g, 0}}, grey);
    scene.emitters.push_back({description::ConstantSky{Spectrum::grey(0.1)}, {}});
    scene.emitters.push_back({description::PointLight{{0, 0, 3}, Spectrum::grey(20)}, {}});
    scene.sensor = camera({0, -4, 2}, {0, 0, 0}, 0.2, 2, 2);
    return scene;
}
constexpr double below_lamp = 0.05 + 20 / (18 * pi);

/// By which probabilities lights are chosen, and whether a render asks what its error rests on.
struct Subject {
    Scene::MakeChooser choose;
    bool guarded;
    bool knows;  ///< whether a render is to reach its error, and say so
};

struct Ground {
    std::unique_ptr<Scene> scene;
    std::string name;
};
std::vector<Ground> grounds(Scene::MakeChooser choose) {
    std::vector<Ground> all;
    for (const double width : {10.0, 300.0, 1e4})
        all.push_back({std::make_unique<Scene>(lamp_under_sky(width), choose), fmt::format("ground of {}", width)});
    return all;
}

double film_mean(const Film& film) {
    double sum = 0;
    for (int y = 0; y < film.size().height; ++y)
        for (int x = 0; x < film.size().width; ++x) sum += film.mean(x, y, 0);
    return sum / (film.size().width * film.size().height);
}

struct Told {
    bool met;
    double deviation;  ///< of the film's mean, over its stated error
};
Told told_of(const Scene& scene, bool guarded, RandomStream& random) {
    const Direct direct(lights_alone);
    const RenderSettings settings{
        .samples_per_pass = 4, .passes = 16, .seed = random.bits(), .crop = whole_film(scene)};
    const ErrorTarget target{0.2, true};
    const RenderedUntil done = render_until(job_of(scene, direct, settings), target, 64);
    const double stated = done.error.rmse / std::sqrt(settings.crop.width * settings.crop.height);
    const double off = std::abs(film_mean(done.rendered.film) - below_lamp);
    return {guarded ? done.met : meets(done.error, target), off / (stated + 1e-3 * below_lamp)};
}

/// A picture that is said to be right is so within five stated errors; and where it is to be known, it is said.
Verdict errors_are_honest(const std::vector<Subject>& subjects, const Run& run) {
    std::vector<Verdict> parts;
    const double most = run.pick(0.1, 0.01);
    for (const auto& [choose, guarded, knows] : subjects)
        for (const Ground& ground : grounds(choose)) {
            const auto misstated = [&](RandomStream& random) {
                const Told told = told_of(*ground.scene, guarded, random);
                return (told.met ? told.deviation > 5 : knows) ? 1.0 : 0.0;
            };
            parts.push_back(mean_at_most(misstated, {.bound = most, .margin = most, .bounds = {0, 1}},
                                         run.part(fmt::format("{} {}", ground.name, parts.size()),
                                                  1 / (3.0 * static_cast<double>(subjects.size())))));
        }
    return all_of(std::move(parts));
}

/// Every light that shines keeps its share, whatever the others are.
Verdict shares_are_kept(Scene::MakeChooser choose) {
    std::vector<BoundedCase> cases;
    for (int n = 2; n <= 1024; n *= 2)
        for (const double brightest : {1.0, 1e3, 1e12}) {
            std::vector<Spectrum> powers(static_cast<std::size_t>(n), Spectrum::grey(1));
            powers[1] = {};
            powers.back() = Spectrum::grey(brightest);
            const LightChooser chooser = choose(powers);
            double least = 1, sum = 0;
            for (std::size_t i = 0; i < powers.size(); ++i) {
                sum += chooser.pmf(i);
                if (luminance(powers[i]) > 0) least = std::min(least, chooser.pmf(i));
            }
            const std::string name = fmt::format("{} lights, one of {}", n, brightest);
            cases.push_back({name + ", share", std::max(0.0, 0.5 / n - least) * n});
            cases.push_back({name + ", sum", std::abs(sum - 1)});
            cases.push_back({name + ", black", n > 2 ? chooser.pmf(1) : 0});
        }
    return within_bound(cases, 1e-12, "of a light's share");
}

}  // namespace

void add_transport_rare_lights(Catalogue& catalogue) {
    catalogue.add(
        {.id = "render/light-choice/shares",
         .statement = "Each of n lights that shine is chosen with a probability of 1/2n at least, a black one "
                      "never.",
         .source = "ours, scenes/emitters/light_chooser.h",
         .kind = Kind::bounded,
         .trial = {shares_are_kept,
                   Scene::MakeChooser(LightChooser::half_by_power),
                   {{"by-power", "In proportion to power alone.", Scene::MakeChooser(LightChooser::by_power)}}}});
    catalogue.add(
        {.id = "render/stated-error/rare-light",
         .statement =
             "A picture of a lamp under the sky, over grounds of 10 to 10^4, reaches a stated error of 20 % and "
             "is as right as it says; by lights chosen by power, which miss the lamp, none says so.",
         .source = "docs/statistics.md",
         .kind = Kind::mean,
         .trial = {
             errors_are_honest,
             std::vector<Subject>{{LightChooser::half_by_power, true, true}, {LightChooser::by_power, true, false}},
             {{"by-power-unasked",
               "Lights are chosen by power, and nothing is asked but the replicates' spread.",
               {{LightChooser::by_power, false, false}}}}}});
}

}  // namespace plumb::suites
