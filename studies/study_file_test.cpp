#include "studies/study_file.h"

#include <gmock/gmock.h>

#include "core/test_folder.h"

namespace plumb {
namespace {

using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::Not;

std::string complaint(const std::string& text) {
    const std::string message = error_of([&] { parse_study(text, "some/study.toml"); });
    EXPECT_THAT(message, Not(HasSubstr("\n")));
    return message;
}

/// A study that is right, with `figure` as the lines of its one figure.
std::string with_figure(const std::string& figure) {
    return "title = 'T'\nn = '16..64'\n[[figure]]\n" + figure;
}

constexpr const char* good = "id = 'a'\nestimators = ['torus']\nintegrands = ['exp']\n";

TEST(StudyFile, GivesDefaultsToFiguresThatSayNothingElse) {
    const Study study = parse_study(R"(
title = "Two figures"
text = "Look."
source = "ours"
seed = 7
n = "16..100"
replicates = 50
metrics = ["rmse", "bias"]
slopes = -2

[[figure]]
id = "first"
estimators = ["independent", "torus"]
integrands = "exp"

[[figure]]
id = "second"
title = "Second"
source_says = "so"
estimators = ["voronoi"]
integrands = ["exp-sum"]
evaluations = [100, 10, 10]
replicates = 20
metrics = "relative_mse"
x = "evaluations"
x_label = "calls"
slopes = [-1, -1.5]
)",
                                    "some/study.toml");
    EXPECT_EQ(study.about.name, "study");
    EXPECT_EQ(study.about.title, "Two figures");
    EXPECT_EQ(study.seed, 7U);
    ASSERT_EQ(study.figures.size(), 2U);
    const FigurePlan &first = study.figures[0], &second = study.figures[1];
    EXPECT_EQ(first.about.title, "first");
    EXPECT_THAT(first.estimators, ElementsAre("independent", "torus"));
    EXPECT_THAT(first.integrands, ElementsAre("exp"));
    EXPECT_EQ(first.budget.unit, Budget::Unit::samples);
    EXPECT_THAT(first.budget.counts, ElementsAre(16, 32, 64));
    EXPECT_EQ(first.replicates, 50U);
    EXPECT_THAT(first.about.metrics, ElementsAre(reports::metric_from("rmse"), reports::metric_from("bias")));
    EXPECT_THAT(first.about.slopes, ElementsAre(-2));
    EXPECT_EQ(second.budget.unit, Budget::Unit::evaluations);
    EXPECT_THAT(second.budget.counts, ElementsAre(10, 100));
    EXPECT_EQ(second.replicates, 20U);
    EXPECT_THAT(second.about.metrics, ElementsAre(reports::metric_from("relative_mse")));
    EXPECT_EQ(second.about.x, reports::Work::evaluations);
    EXPECT_THAT(second.about.slopes, ElementsAre(-1, -1.5));
}

TEST(StudyFile, MayHaveEstimatorsOfItsOwn) {
    const Study study = parse_study(R"(
title = "Own estimators"
[[estimator]]
id = "quarters"
method = "step-strata"
masses = [1, 2, 3, 4]
[[estimator]]
id = "quarters in tens"
method = "batches"
of = "quarters"
size = 10
[[estimator]]
id = "hundred in batches"
method = "batches"
of = "independent"
total = 100
[[figure]]
id = "a"
estimators = ["quarters", "quarters in tens", "hundred in batches"]
integrands = ["exp"]
n = [16, 20]
)",
                                    "own.toml");
    const auto evaluations = [&](const char* id, std::uint64_t n) {
        RandomStream random(1);
        const auto& estimator = find_estimator<1>(study, id);
        return estimator.run([](const Point<1>&) { return 1.0; }, n, random).evaluations;
    };
    EXPECT_EQ(evaluations("quarters", 20), 20U);
    EXPECT_EQ(evaluations("quarters in tens", 30), 30U);
    EXPECT_EQ(evaluations("hundred in batches", 20), 100U);
    EXPECT_EQ(evaluations("hundred in batches", 30), 90U);
    EXPECT_TRUE(knows_estimator<2>(study, "hundred in batches"));
    EXPECT_FALSE(knows_estimator<2>(study, "quarters in tens"));
}

TEST(StudyFile, IsComplainedAboutByLineAndKey) {
    EXPECT_EQ(complaint(with_figure(good)), "");
    EXPECT_THAT(complaint("title = \n"), HasSubstr("some/study.toml:1: not TOML: "));
    EXPECT_THAT(complaint("title = 3\n"), HasSubstr("some/study.toml:1: title: 3 found; a string is accepted"));
    EXPECT_THAT(complaint("text = 'no title'\n"), HasSubstr("title: is missing"));
    EXPECT_THAT(complaint("title = 'T'\ntxet = ''\n"), HasSubstr(":2: unknown key 'txet'; did you mean 'text'"));
    EXPECT_THAT(complaint("title = 'T'\nreplicates = 1\n"),
                HasSubstr(":2: replicates: 1 found; an integer from 2 to 100000000 is accepted"));
    EXPECT_THAT(complaint("title = 'T'\nseed = 1.5\n"), HasSubstr(":2: seed: 1.5 found"));
    EXPECT_THAT(complaint("title = 'T'\nseed = true\n"), HasSubstr(":2: seed: true or false found"));
    EXPECT_THAT(complaint("title = 'T'\nn = '16..4'\n"), HasSubstr(":2: n: '16..4' runs backwards"));
    EXPECT_THAT(complaint("title = 'T'\nn = [0]\n"), HasSubstr(":2: n: '0' is not a sample count"));
    EXPECT_THAT(complaint("title = 'T'\nn = [-4]\n"), HasSubstr(":2: n: '-4' is not a sample count"));
    EXPECT_THAT(complaint("title = 'T'\nfigure = 3\n"), HasSubstr(":2: figure: 3 found; tables are accepted"));
    EXPECT_THAT(complaint("title = 'T'\n"), HasSubstr("no figure"));
}

TEST(StudyFile, OfAWrongFigureIsComplainedAbout) {
    EXPECT_THAT(complaint(with_figure("id = 'A b'\n")), HasSubstr(":4: figure.id: 'A b' found; lower-case"));
    EXPECT_THAT(complaint(with_figure(std::string(good) + "[[figure]]\n" + good)),
                HasSubstr(":8: figure.id: 'a' is the id of an earlier figure"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = ['torsu']\nintegrands = ['exp']\n")),
                HasSubstr(":5: figure.estimators: unknown 1D estimator 'torsu'; did you mean 'torus'"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = ['cmj']\nintegrands = ['exp']\n")),
                HasSubstr("unknown 1D estimator 'cmj'"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = ['torus']\nintegrands = ['exq']\n")),
                HasSubstr(":6: figure.integrands: unknown integrand 'exq'; did you mean 'exp'"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = []\nintegrands = ['exp']\n")),
                HasSubstr(":5: figure.estimators: an empty list found"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = ['torus', 3]\nintegrands = ['exp']\n")),
                HasSubstr(":5: figure.estimators: 3 found; a name is accepted"));
    EXPECT_THAT(complaint(with_figure(std::string(good) + "metric = 'mse'\n")),
                HasSubstr(":7: unknown key 'figure.metric'; did you mean 'figure.metrics'"));
    EXPECT_THAT(complaint(with_figure(std::string(good) + "metrics = ['mses']\n")),
                HasSubstr(":7: figure.metrics: unknown metric 'mses'; did you mean 'mse'"));
    EXPECT_THAT(complaint(with_figure(std::string(good) + "x = 'second'\n")),
                HasSubstr(":7: figure.x: unknown axis 'second'; did you mean 'seconds'"));
    EXPECT_THAT(complaint(with_figure(std::string(good) + "n = 'many'\n")), HasSubstr(":7: figure.n: 'many'"));
    EXPECT_THAT(complaint(with_figure(std::string(good) + "n = [4]\nevaluations = [4]\n")),
                HasSubstr(":8: figure.evaluations: stands beside n"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = ['torus']\nintegrands = ['sine']\n"
                                      "metrics = 'relative_mse'\n")),
                HasSubstr(":7: figure.metrics: relative_mse of 'sine', whose integral is 0"));
    EXPECT_THAT(complaint("title = 'T'\n[[figure]]\n" + std::string(good)), HasSubstr("figure.n: is missing"));
}

TEST(StudyFile, OfAWrongEstimatorIsComplainedAbout) {
    const auto with_estimator = [](const std::string& lines) { return "title = 'T'\n[[estimator]]\n" + lines; };
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'batch'\n")),
                HasSubstr(":4: estimator.method: unknown method 'batch'; did you mean 'batches'"));
    EXPECT_THAT(complaint(with_estimator("id = 'torus'\nmethod = 'batches'\nof = 'torus'\nsize = 2\n")),
                HasSubstr(":3: estimator.id: 'torus' is the name of another estimator"));
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'batches'\nof = 'torsu'\nsize = 2\n")),
                HasSubstr(":5: estimator.of: unknown 1D estimator 'torsu'; did you mean 'torus'"));
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'batches'\nof = 'torus'\n")),
                HasSubstr(":4: estimator.method: batches need either size or total"));
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'batches'\nof = 'torus'\nsize = 0\n")),
                HasSubstr(":6: estimator.size: 0 found"));
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'step-strata'\nmasses = [1, -1]\n")),
                HasSubstr(":5: estimator.masses: "));
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'step-strata'\nmasses = [1, 1]\nedges = [0, 1]\n")),
                HasSubstr(":6: estimator.edges: "));
    EXPECT_THAT(complaint(with_estimator("id = 'e'\nmethod = 'step-strata'\nsize = 1\n")),
                HasSubstr(":5: unknown key 'estimator.size'"));
}

std::string with_render(const std::string& lines) {
    return "title = 'T'\nn = [4]\n[[estimator]]\nid = 'mine'\nmethod = 'render'\n" + lines +
           "[[figure]]\nid = 'a'\nestimators = ['mine', 'path']\nintegrands = ['quad_light']\n";
}

TEST(StudyFile, TakesParametersOfIntegrators) {
    const Study study = parse_study(with_render("integrator = 'path'\nsampler = 'sobol'\n"
                                                "parameters = { roulette-start = 3 }\n"),
                                    "s.toml");
    const RenderMethod render = find_scene_method(study, "mine").render;
    EXPECT_EQ(render.integrator, "path");
    EXPECT_EQ(render.sampler, "sobol-owen");
    EXPECT_EQ(render.parameters.at("roulette-start"), "3");
    EXPECT_EQ(render.limits.roulette_edges, 3);
    EXPECT_EQ(find_scene_method(study, "path").render.limits.roulette_edges, PathLimits{}.roulette_edges);
}

TEST(StudyFile, OfWrongParametersIsComplainedAboutInPlace) {
    EXPECT_THAT(complaint(with_render("integrator = 'paht'\n")),
                HasSubstr(":6: estimator.integrator: unknown integrator 'paht'; did you mean 'path'"));
    EXPECT_THAT(complaint(with_render("integrator = 'path'\nsampler = 'sobl'\n")),
                HasSubstr(":7: estimator.sampler: unknown sampler 'sobl'"));
    EXPECT_THAT(complaint(with_render("integrator = 'path'\nparameters = { roulette-strat = 3 }\n")),
                HasSubstr(":7: estimator.parameters: unknown parameter 'roulette-strat'; did you mean"));
    EXPECT_THAT(complaint(with_render("integrator = 'path'\nparameters = { roulette-start = -3 }\n")),
                HasSubstr(":7: estimator.parameters: parameter roulette-start is '-3'; accepted are 0 to "));
    EXPECT_THAT(complaint(with_render("integrator = 'path'\nparameters = { roulette-start = [3] }\n")),
                HasSubstr(":7: estimator.parameters: roulette-start is a list; a number"));
    EXPECT_THAT(complaint(with_render("integrator = 'path'\nparameters = 3\n")),
                HasSubstr(":7: estimator.parameters: 3 found; a table is accepted"));
    EXPECT_THAT(complaint(with_render("integrator = 'path'\nsize = 3\n")),
                HasSubstr(":7: unknown key 'estimator.size'"));
}

TEST(StudyFile, LoadsASceneOnceAndHoldsPartsToItsFilm) {
    const auto on = [](const std::string& parts) {
        return with_figure("id = 'a'\nestimators = ['path']\nintegrands = " + parts + "\n");
    };
    const Study study = parse_study(on("['quad_light', 'quad_light:8,8', 'quad_light:0,0,4,4']"), "s.toml");
    ASSERT_EQ(study.scene_parts.size(), 3U);
    EXPECT_EQ(study.scene_parts[0].scene, study.scene_parts[1].scene);
    EXPECT_EQ(study.scene_parts[1].scene, study.scene_parts[2].scene);
    EXPECT_THAT(complaint(on("['quad_light:8,9999']")),
                HasSubstr("figure.integrands: quad_light:8,9999,1,1: accepted are pixels of a film of "));
}

TEST(StudyFile, TakesScenesForIntegrands) {
    const std::string scene = "id = 'a'\nestimators = ['path', 'path+sobol']\nintegrands = ['cornell_box:8,8']\n";
    EXPECT_EQ(parse_study(with_figure(scene + "reference = 'auto'\n"), "study.toml").figures.at(0).reference, "auto");
    EXPECT_THAT(complaint("title = 'T'\nevaluations = [16]\n[[figure]]\n" + scene),
                HasSubstr("of the scene 'cornell_box:8,8'; n is accepted"));
    EXPECT_THAT(complaint(with_figure("id = 'a'\nestimators = ['paht']\nintegrands = ['cornell_box']\n")),
                HasSubstr("figure.estimators: unknown integrator 'paht'; did you mean 'path'?"));
}

}  // namespace
}  // namespace plumb
