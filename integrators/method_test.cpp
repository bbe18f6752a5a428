#include "integrators/method.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "integrators/drivers/drivers.h"
#include "integrators/drivers/frameless.h"
#include "integrators/drivers/sampler.h"
#include "integrators/integrators.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::string complaint(const RenderMethod& method) {
    try {
        resolved(method);
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(RenderMethod, ResolvesNamesAndParameters) {
    const RenderMethod method = resolved({"path", "frameless", "sobol", {}, {{"pixel-share", "5e-1"}}});
    EXPECT_EQ(method.sampler, "sobol-owen");
    EXPECT_THAT(method.parameters, ElementsAre(Pair("pixel-share", "0.5"), Pair("roulette-start", "5")));
}

TEST(RenderMethod, HasOneRoulette) {
    const auto edges = [](const RenderMethod& method) {
        return dynamic_cast<const PathTracer&>(*estimator_of(method)).limits.roulette_edges;
    };
    const RenderMethod by_parameter =
        resolved({.limits = {.roulette_edges = 3}, .parameters = {{"roulette-start", "8"}}});
    EXPECT_EQ(by_parameter.limits.roulette_edges, 8);
    EXPECT_EQ(edges(by_parameter), 8);
    const RenderMethod by_limit = resolved({.limits = {.roulette_edges = 3}});
    EXPECT_EQ(by_limit.parameters.at("roulette-start"), "3");
    EXPECT_EQ(edges(by_limit), 3);
}

TEST(RenderMethod, MakesTheDriverOfTheJob) {
    const Scene scene(load_mitsuba(scene_file("quad_light")));
    const RenderMethod method = resolved({"direct", "frameless", "stratified", {}, {{"pixel-share", "0.5"}}});
    const auto estimator = estimator_of(method);
    const RenderJob job = job_of(method, scene, *estimator, {});
    EXPECT_EQ(job.settings.sampler, "stratified");
    EXPECT_EQ(dynamic_cast<const Frameless&>(*job.driver).share, 0.5);
}

TEST(RenderMethod, NamesWhatIsNotAccepted) {
    EXPECT_EQ(complaint({.driver = "framless"}), "unknown driver 'framless'; did you mean 'frameless'?");
    EXPECT_THAT(complaint({.integrator = "pth"}), HasSubstr("did you mean 'path'?"));
    EXPECT_THAT(complaint({.sampler = "halton"}), HasSubstr("sobol-owen"));
    EXPECT_EQ(complaint({.parameters = {{"pixel-share", "1"}}}),
              "unknown parameter 'pixel-share'; known: roulette-start");
    EXPECT_EQ(complaint({.driver = "frameless", .parameters = {{"pixel-share", "0"}}}),
              "parameter pixel-share is '0'; accepted are 0.001 to 1");
    EXPECT_EQ(complaint({.integrator = "direct", .parameters = {{"x", "0"}}}), "parameter 'x': none is accepted here");
    EXPECT_THAT(complaint({.integrator = "path", .limits = {.strategy = Strategy{1, 2}}}),
                HasSubstr("accepted is bdpt"));
    EXPECT_THAT(complaint({.integrator = "direct-bsdf", .limits = {.max_edges = 3}}),
                HasSubstr("accepted are 2 and -1"));
}

TEST(Integrators, AreAskedForReferencesByTheirRank) {
    std::vector<std::string> ids;
    for (const NamedIntegrator* one : reference_integrators()) ids.push_back(one->id);
    EXPECT_THAT(ids, ElementsAre("bdpt", "path", "direct"));
}

TEST(Samplers, AreTheRandomisedPointSets) {
    std::vector<std::string> ids;
    for (const PointSet<2>& set : samplers()) ids.push_back(set.id);
    EXPECT_THAT(ids, ElementsAre("independent", "stratified", "latin-hypercube", "cmj", "halton-shifted",
                                 "hammersley-shifted", "sobol-owen", "zero-two-xor", "zero-two-owen"));
    for (const std::string& id : ids) {
        Sampler sampler(id, 16);
        EXPECT_EQ(sampler.independent(), id == ids.front());
        std::array<int, 4> quadrants{};
        for (std::uint32_t i = 0; i < 16; ++i) {
            const auto [x, y] = sampler.start({7, 3, i}).at({2, Use::direction}).u;
            ++quadrants[(x < 0.5 ? 0u : 1u) + (y < 0.5 ? 0u : 2u)];
        }
        if (id == "stratified" || id == "cmj" || id.ends_with("owen") || id.ends_with("xor")) {
            EXPECT_THAT(quadrants, ElementsAre(4, 4, 4, 4)) << id;
        }
    }
}

}  // namespace
}  // namespace plumb
