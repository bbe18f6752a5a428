#include "studies/own/integrate_samples.h"

#include <iostream>
#include <iterator>

#include "core/error.h"
#include "core/file.h"
#include "core/moments.h"
#include "core/parallel.h"
#include "estimators/reweighting/sample_weighting.h"
#include "studies/own/user_integrand.h"

namespace plumb::own {
namespace {

std::string text_of(const std::string& file) {
    if (file != "-") return read_file(file);
    return {std::istreambuf_iterator<char>(std::cin), {}};
}

void check_task(const IntegralTask& task) {
    for (const auto& [given, option] : {std::pair{task.n.has_value(), "--n"},
                                        {task.error.has_value(), "--error"},
                                        {task.channel.has_value(), "--channel"},
                                        {task.lookup.has_value(), "--lookup"}})
        if (given) throw Error(fmt::format("{} does not go with a file of samples", option));
    if (task.batches && task.what.size() > 1)
        throw Error("--batches goes with one file of samples: several files are independent sets already");
}

template <int D>
Estimate weighted(const SampleWeighting<D>& method, const SampleSet<D>& set, std::size_t first, std::size_t count) {
    const std::span places = std::span(set.places).subspan(first, count);
    const std::vector<double> weights = method.weights(places);
    Estimate estimate{.evaluations = count};
    for (std::size_t i = 0; i < count; ++i) estimate.value += weights[i] * set.values[first + i];
    if (method.id == "independent") {
        Moments moments;
        for (std::size_t i = 0; i < count; ++i) moments.add(set.values[first + i]);
        estimate.standard_error = moments.standard_error();
    }
    return estimate;
}

// The set cut into batches of consecutive samples, sizes differing by at most one.
template <int D>
Runs batch_runs(const SampleWeighting<D>& method, const SampleSet<D>& set, std::size_t batches) {
    const std::size_t n = set.places.size();
    Runs runs{.n = n / batches, .estimates = std::vector<Estimate>(batches)};
    for_batches(batches, [&](std::size_t b) {
        const std::size_t first = b * (n / batches) + std::min(b, n % batches);
        runs.estimates[b] = weighted(method, set, first, n / batches + (b < n % batches ? 1 : 0));
    });
    return runs;
}

// Batches of doubling size, up to the asked number of them: the convergence that independent samples show.
template <int D>
std::vector<Runs> sets_of_batches(const SampleWeighting<D>& method, const SampleSet<D>& set, std::uint64_t batches) {
    if (batches > set.places.size())
        throw Error(fmt::format("--batches {}: the file has {} samples; accepted are 2 to {}", batches,
                                set.places.size(), set.places.size()));
    std::vector<Runs> sets;
    for (int halvings = 6; halvings >= 0; --halvings)
        if (const std::uint64_t count = batches << halvings; halvings == 0 || set.places.size() / count >= 16)
            sets.push_back(batch_runs(method, set, count));
    return sets;
}

template <int D>
std::vector<Runs> sets_of_files(const SampleWeighting<D>& method, const std::vector<SampleSet<D>>& files) {
    Runs runs;
    for (const SampleSet<D>& file : files) {
        runs.n = file.places.size();
        runs.estimates.push_back(weighted(method, file, 0, file.places.size()));
    }
    return {runs};
}

std::string about_error(const IntegralTask& task, const Answer& answer) {
    if (task.batches)
        return "the error is from batches in the order of the file: right only where the samples are independent of "
               "each "
               "other, not stratified, quasi-random or sorted";
    if (task.what.size() > 1) return "the error is from the files: right where they are independent sets";
    if (std::isinf(answer.estimate.standard_error))
        return "one set tells nothing about its own error: give several files, or --batches 16 where the samples are "
               "independent of each other";
    return "the error is right only where the samples are independent of each other";
}

template <int D>
Answer integrate(const std::vector<NumberTable>& tables, const IntegralTask& task) {
    const SampleWeighting<D>& method = find_sample_weighting<D>(task.method.value_or("voronoi"));
    std::vector<SampleSet<D>> files;
    std::size_t repeated = 0;
    for (const NumberTable& table : tables) {
        files.push_back(samples_of<D>(table, task.domain));
        repeated += repeated_places<D>(files.back().places, method.id == "torus");
    }
    const std::vector<Runs> sets =
        task.batches ? sets_of_batches(method, files.front(), *task.batches) : sets_of_files(method, files);
    Answer answer{.integrand = fmt::format("{}", fmt::join(task.what, " ")), .method = method.id};
    answer.n = sets.back().n;
    answer.runs = sets.back().estimates.size();
    answer.estimate = answer.runs == 1 ? sets.back().estimates.front() : mean_of(sets.back());
    answer.all_evaluations = answer.estimate.evaluations;
    answer.known = {method.known, about_error(task, answer)};
    if (repeated > 0)
        answer.known.push_back(fmt::format("{} samples repeat an earlier place and share its cell", repeated));
    if (task.batches) answer.series = series_of(sets, answer);
    return answer;
}

}  // namespace

Answer integrate_samples(const IntegralTask& task) {
    check_task(task);
    std::vector<NumberTable> tables;
    for (const std::string& file : task.what)
        tables.push_back(
            in_order(parse_csv(text_of(file), file == "-" ? "standard input" : file), {{"x", "f"}, {"x", "y", "f"}}));
    for (const NumberTable& table : tables) {
        if (table.columns != tables.front().columns)
            throw Error(fmt::format("{}: {} columns found; {} has {}", table.name, table.columns, tables.front().name,
                                    tables.front().columns));
    }
    return tables.front().columns == 2 ? integrate<1>(tables, task) : integrate<2>(tables, task);
}

}  // namespace plumb::own
