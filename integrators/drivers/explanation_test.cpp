#include "integrators/drivers/explanation.h"

#include <gtest/gtest.h>

#include <map>

#include "core/error.h"
#include "core/parallel.h"
#include "integrators/drivers/render.h"
#include "integrators/integrators.h"
#include "scenes/film/exact_sum.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

const Scene& shipped(const std::string& name) {
    static std::map<std::string, Scene> scenes;
    auto found = scenes.find(name);
    if (found == scenes.end()) found = scenes.try_emplace(name, load_mitsuba(scene_file(name), {})).first;
    return found->second;
}

struct Subject {
    std::string integrator, scene;
    PathLimits limits = {};
};

class Explained : public testing::TestWithParam<Subject> {
protected:
    const Scene& scene = shipped(GetParam().scene);
    std::unique_ptr<PathEstimator> estimator = make_integrator(GetParam().integrator, GetParam().limits);
    FilmSize film = scene.sensor().film();
};

TEST_P(Explained, SumsToWhatTheRendererPutsIntoThePicture) {
    const FilmRegion crop{film.width / 4, film.height / 4, film.width / 2, film.height / 2};
    const RenderSettings settings{.samples_per_pass = 1, .passes = 1, .seed = 7, .crop = crop};
    const Film rendered = render(scene, *estimator, settings).film;
    std::map<std::array<int, 2>, std::array<ExactSum, 3>> sums;
    const int exponent = rendered.layers()[0].exponent;
    const auto add = [&](int x, int y, const Spectrum& value) {
        for (std::size_t c = 0; c < 3; ++c) sums[{x - crop.x, y - crop.y}][c].add(std::ldexp(value[c], -exponent));
    };
    bool light = false;
    for (int y = crop.y; y < crop.y + crop.height; ++y)
        for (int x = crop.x; x < crop.x + crop.width; ++x) {
            const Explanation told = explain(scene, *estimator, settings, x, y, 0);
            add(x, y, told.value);
            for (const SplatOnPixel& splat : told.splatted) add(splat.x, splat.y, splat.value);
            light = light || !is_black(told.sum());
        }
    EXPECT_TRUE(light);
    for (const auto& [pixel, sum] : sums)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(std::ldexp(sum[c].value(), exponent), rendered.mean(pixel[0], pixel[1], c));
}

TEST_P(Explained, FindsWhatItsSplatsAreMadeOf) {
    const RenderSettings settings{.passes = 16, .seed = 7, .crop = {0, 0, film.width, film.height}};
    std::size_t splats = 0;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const Explanation told = explain(scene, *estimator, settings, film.width / 2, film.height * 2 / 3, i);
        std::vector<Spectrum> sums(told.record.splats.size());
        for (const PathStory::Finding& finding : told.story.findings) {
            EXPECT_GE(finding.weight, 0);
            EXPECT_LE(finding.weight, 1);
            if (is_black(finding.value())) continue;
            ASSERT_LT(finding.splat, sums.size());
            sums[finding.splat] += finding.value();
            EXPECT_EQ(finding.strategy.edges(), told.record.splats[finding.splat].edges);
        }
        for (std::size_t k = 0; k < sums.size(); ++k, ++splats)
            for (std::size_t c = 0; c < 3; ++c) {
                const double value = told.record.splats[k].value[c];
                EXPECT_NEAR(sums[k][c], value, 1e-12 * value);
            }
        for (std::size_t k = 0; k + 1 < told.record.vertices.size(); ++k) {  // each was left for the next
            const auto left = std::ranges::find(told.story.scatterings, k + 1, &PathStory::Scattering::vertex);
            ASSERT_NE(left, told.story.scatterings.end());
            EXPECT_TRUE(left->survived);
            EXPECT_GT(left->pdf, 0);
        }
    }
    EXPECT_GT(splats, 0u);
}

TEST_P(Explained, IsTheSameTwice) {
    const RenderSettings settings{.sampler = "sobol", .seed = 3, .crop = {0, 0, film.width, film.height}};
    const Explanation one = explain(scene, *estimator, settings, 20, 40, 5),
                      other = explain(scene, *estimator, settings, 20, 40, 5);
    EXPECT_EQ(one.sum(), other.sum());
    EXPECT_EQ(one.story.findings.size(), other.story.findings.size());
    EXPECT_EQ(one.start.film, other.start.film);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Explained,
                         testing::Values(Subject{"path", "cornell_box"}, Subject{"path", "glass"},
                                         Subject{"path", "cornell_box", {.roulette_edges = 1, .length = 3}},
                                         Subject{"light", "cornell_box"}, Subject{"bdpt", "cornell_box"},
                                         Subject{"bdpt", "cornell_box", {.strategy = Strategy{2, 2}}},
                                         Subject{"bdpt", "point_light"}, Subject{"direct", "cornell_box"},
                                         Subject{"light", "glass"}),
                         [](const auto& info) { return info.param.integrator + std::to_string(info.index); });

TEST(Explain, AddsUpOverThePassesOfPointSets) {
    const Scene& scene = shipped("cornell_box");
    const PathTracer path;
    RenderSettings settings = with_samples({.sampler = "sobol", .seed = 3, .crop = {64, 60, 1, 1}}, 32);
    const Film rendered = render(scene, path, settings).film;
    Spectrum sum;
    for (std::uint32_t i = 0; i < 32; ++i) sum += explain(scene, path, settings, 64, 60, i).value;
    EXPECT_NEAR(sum[0] / 32, rendered.mean(0, 0, 0), 1e-14);
}

TEST(Explain, NamesWhatIsNotThere) {
    const Scene& scene = shipped("cornell_box");
    const RenderSettings settings{.samples_per_pass = 1, .passes = 1, .crop = {3, 4, 1, 1}};
    EXPECT_THROW(explain(scene, PathTracer(), settings, 4, 4, 0), Error);
    EXPECT_THROW(explain(scene, PathTracer(), settings, 3, -1, 0), Error);
    EXPECT_THROW(explain(scene, PathTracer(), settings, 3, 4, 1), Error);
}

}  // namespace
}  // namespace plumb
