#include "studies/own/integrate.h"

#include "core/error.h"
#include "estimators/estimator.h"
#include "studies/own/integrate_samples.h"
#include "verification/evidence/rare_values.h"

namespace plumb::own {
namespace {

constexpr const char* default_method = "sobol-owen";
constexpr std::uint64_t default_n = 1024;

template <int D>
const Estimator<D>& method_for(const UserIntegrand<D>& f, const IntegralTask& task) {
    constexpr int other = 3 - D;
    const std::string id = task.method.value_or(default_method);
    const auto named = [&](const auto& estimator) { return estimator.id == id; };
    if (std::ranges::none_of(estimators<D>(), named) && std::ranges::any_of(estimators<other>(), named))
        throw Error(fmt::format("method '{}' is for {}D integrands, {} is {}D; see plumb list estimators", id, other,
                                f.name, D));
    return find_estimator<D>(id);
}

/// N/64, N/32 … N: what the plot shows for a fixed n.
std::vector<std::uint64_t> counts_up_to(std::uint64_t n) {
    std::vector<std::uint64_t> counts;
    for (int halvings = 6; halvings >= 0; --halvings)
        if (const std::uint64_t m = n >> halvings; m >= std::min<std::uint64_t>(n, 4)) counts.push_back(m);
    return counts;
}

void tell(const IntegralTask& task, double share, const Runs& seen) {
    if (task.progress) task.progress(share, seen);
}

// Errors of independent samples fall as n^-1/2, others faster; n doubles, and the answer takes as much as all looks.
double share_of_search(const Runs& look, const ErrorTarget& target) {
    const Estimate seen = mean_of(look);
    const double ratio = seen.standard_error / target.absolute(seen.value);
    return 0.5 / std::exp2(std::ceil(std::log2(std::max(1.0, 2.25 * ratio * ratio))));
}

template <int D>
Answer integrate(const UserIntegrand<D>& f, const IntegralTask& task, std::uint64_t seed) {
    const Estimator<D>& method = method_for(f, task);
    const IndependentRun run = [&](std::uint64_t n, RandomStream& random) {
        const Function<D> own = f.value;
        return method.run(own, n, random);
    };
    Answer answer{
        .integrand = f.name, .method = method.id, .runs = method.randomised ? task.replicates : 1, .exact = f.exact};
    const auto runs_at = [&](std::uint64_t n, std::string_view purpose) {
        return independent_runs(run, n, answer.runs, seed, purpose);
    };
    std::vector<Runs> sets;
    if (task.error) {
        if (!method.randomised)
            throw Error(
                fmt::format("--error: method '{}' is deterministic, so runs cannot tell its error; accepted are "
                            "randomised ones such as stratified, sobol-owen, torus-tent",
                            method.id));
        const auto progress = [&](const Runs& look) { tell(task, share_of_search(look, *task.error), look); };
        Search search = search_sample_count(run, *task.error, answer.runs, task.max_evaluations, seed, progress);
        sets = std::move(search.looks);
        answer.all_evaluations = mean_of(sets.back()).evaluations;  // the last look makes room for the answer
        sets.back() = runs_at(sets.back().n, "answer");
    } else if (answer.exact || method.randomised) {
        const std::uint64_t most = task.n.value_or(default_n);
        for (const std::uint64_t n : counts_up_to(most)) {
            sets.push_back(runs_at(n, n == most ? "answer" : "look"));
            tell(task, static_cast<double>(n) / static_cast<double>(most), sets.back());  // the last takes half
        }
    } else {
        sets.push_back(runs_at(task.n.value_or(default_n), "answer"));
    }

    answer.n = sets.back().n;
    answer.estimate = mean_of(sets.back());
    for (const Runs& runs : sets) answer.all_evaluations += mean_of(runs).evaluations;
    if (task.error) {
        answer.target = task.error->absolute(answer.estimate.value);
        const bool enough = answer.estimate.evaluations >= least_evaluations;
        answer.target_met = enough && task.error->met_by(answer.estimate) && !skewed(sets.back());
        answer.known.push_back("n was chosen by looking; value and error are from fresh runs at that n");
        if (!enough)
            answer.known.push_back(fmt::format("an error is believed from {} evaluations on: see --max-evaluations",
                                               with_commas(least_evaluations)));
    }
    if (skewed(sets.back()))
        answer.known.push_back("the runs are skewed, as with spikes or infinite variance: the error is too small");
    if (!method.randomised)
        answer.known.push_back("the method is deterministic: its error is unknown, since every run is the same");
    else if (std::isinf(answer.estimate.standard_error))
        answer.known.push_back("all runs gave the same value: no spread seen says nothing about the error");
    else if (!method.unbiased)
        answer.known.push_back("the method is biased: the error is its spread and leaves the bias out");
    if (method.randomised) answer.known.push_back(what_could_hide(answer.estimate.evaluations));
    if (answer.exact || method.randomised) {
        answer.series = series_of(sets, answer);
        if (f.shipped && method.expected_slope) answer.series->expected_slope = method.expected_slope(*f.shipped);
    }
    return answer;
}

}  // namespace

std::vector<Answer> integrate(const IntegralTask& task, std::uint64_t seed) {
    if (kind_of(task.what.front()) == InputKind::samples) return {integrate_samples(task)};
    std::vector<Answer> answers;
    std::visit(
        [&](const auto& integrands) {
            for (const auto& f : integrands) answers.push_back(integrate(f, task, seed));
        },
        read_integrands(task));
    return answers;
}

}  // namespace plumb::own
