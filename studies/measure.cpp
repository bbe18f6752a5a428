#include "studies/measure.h"

#include <fmt/ranges.h>

#include "analytic/any_integrand.h"
#include "core/error.h"
#include "core/named.h"
#include "studies/scene_series.h"
#include "verification/evidence/convergence.h"

namespace plumb {
namespace {

template <int D>
std::vector<std::uint64_t> sample_counts(const Budget& budget, const Estimator<D>& estimator,
                                         const Integrand<D>& integrand, const Run& run) {
    if (budget.unit == Budget::Unit::samples) return budget.counts;
    std::vector<std::uint64_t> n;
    for (const std::uint64_t evaluations : budget.counts)
        n.push_back(samples_within(evaluations, estimator, integrand, run));
    n.erase(std::unique(n.begin(), n.end()), n.end());
    return n;
}

template <int D>
reports::FigurePanel measure_panel(const Study& study, const FigurePlan& plan, const Integrand<D>& integrand,
                                   const Run& run, const std::function<void(const std::string&)>& progress) {
    reports::FigurePanel panel{.integrand = integrand.id, .integral = integrand.integral_value(), .series = {}};
    for (const std::string& id : plan.estimators) {
        const std::string what = fmt::format("{}: {} on {}", plan.about.id, id, integrand.id);
        progress(what);
        const Estimator<D>& estimator = find_estimator<D>(study, id);
        try {
            const auto n = sample_counts(plan.budget, estimator, integrand, run);
            panel.series.push_back(measure_series(estimator, integrand, n, plan.replicates, run));
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", what, error.what()));
        }
    }
    return panel;
}

reports::FigurePanel measure_panel(const Study& study, const FigurePlan& plan, const ScenePart& part, const Run& run,
                                   const std::function<void(const std::string&)>& progress) {
    const std::string what = fmt::format("{}: {} on {}", plan.about.id, fmt::join(plan.estimators, ", "), part.id);
    progress(what);
    reports::FigurePanel panel{.integrand = part.id, .series = {}, .unit = "rays"};
    SceneMeasure measure{{}, plan.budget.counts, plan.replicates, plan.reference};
    for (const std::string& id : plan.estimators) {
        measure.methods.push_back(find_scene_method(study, id));
        panel.methods[id] = in_words(measure.methods.back());
    }
    try {
        SceneSeries measured = measure_scene(part, measure, run);
        panel.integral = measured.truth;
        panel.series = std::move(measured.series);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", what, error.what()));
    }
    return panel;
}

}  // namespace

template <int D>
Series measure_series(const Estimator<D>& estimator, const Integrand<D>& integrand, const std::vector<std::uint64_t>& n,
                      std::uint64_t replicates, const Run& run) {
    const ConvergenceSetting setting{.estimator = estimator.id,
                                     .integrand = integrand.id,
                                     .truth = integrand.integral_value(),
                                     .n = n,
                                     .replicates = replicates};
    const Replicate replicate = [&](std::uint64_t samples, RandomStream& random) {
        return estimator.run(integrand.value, samples, random);
    };
    Series series = measure_convergence(replicate, setting, run.part(estimator.id + " on " + integrand.id));
    if (estimator.expected_slope) series.expected_slope = estimator.expected_slope(integrand);
    return series;
}
template Series measure_series<1>(const Estimator<1>&, const Integrand<1>&, const std::vector<std::uint64_t>&,
                                  std::uint64_t, const Run&);
template Series measure_series<2>(const Estimator<2>&, const Integrand<2>&, const std::vector<std::uint64_t>&,
                                  std::uint64_t, const Run&);

template <int D>
std::uint64_t samples_within(std::uint64_t evaluations, const Estimator<D>& estimator, const Integrand<D>& integrand,
                             const Run& run) {
    const auto fits = [&](std::uint64_t n) {
        RandomStream random = run.part("trial").random(0);
        return estimator.run(integrand.value, n, random).evaluations <= evaluations;
    };
    if (fits(evaluations)) return evaluations;
    std::uint64_t low = 1, high = evaluations;  // low fits or is 1, high does not fit
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}
template std::uint64_t samples_within<1>(std::uint64_t, const Estimator<1>&, const Integrand<1>&, const Run&);
template std::uint64_t samples_within<2>(std::uint64_t, const Estimator<2>&, const Integrand<2>&, const Run&);

reports::FigureResult measure_figure(const Study& study, const FigurePlan& plan, const Run& run,
                                     const std::function<void(const std::string&)>& progress) {
    reports::FigureResult figure{plan.about, {}};
    for (const std::string& id : plan.integrands) {
        const auto measured = [&](const auto& subject) { return measure_panel(study, plan, subject, run, progress); };
        const auto integrand = known_integrand(id);
        figure.panels.push_back(integrand ? std::visit([&](const auto* f) { return measured(*f); }, *integrand)
                                          : measured(find_named(study.scene_parts, id, "scene")));
    }
    return figure;
}

std::size_t steps_of(const FigurePlan& plan) {
    std::size_t steps = 0;
    for (const std::string& id : plan.integrands) steps += known_integrand(id) ? plan.estimators.size() : 1;
    return steps;
}

std::size_t steps_of(const Study& study) {
    std::size_t steps = 0;
    for (const FigurePlan& plan : study.figures) steps += steps_of(plan);
    return steps;
}

std::vector<reports::FigureResult> measure_study(const Study& study, const Run& run,
                                                 const std::function<void(const std::string&)>& progress) {
    std::vector<reports::FigureResult> figures;
    for (const FigurePlan& plan : study.figures) figures.push_back(measure_figure(study, plan, run, progress));
    return figures;
}

}  // namespace plumb
