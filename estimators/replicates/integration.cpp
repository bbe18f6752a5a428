#include "estimators/replicates/integration.h"

#include <chrono>
#include <cmath>

#include "core/moments.h"
#include "core/parallel.h"
#include "estimators/replicates/mean_of_runs.h"

namespace plumb {

Runs independent_runs(const IndependentRun& run, std::uint64_t n, std::uint64_t count, std::uint64_t seed,
                      std::string_view purpose) {
    Runs runs{.n = n, .estimates = std::vector<Estimate>(count)};
    std::vector<double> seconds(count);
    const std::uint64_t stream = stream_id(fmt::format("{} n={}", purpose, n));
    for_batches(count, [&](std::size_t r) {
        const auto start = std::chrono::steady_clock::now();
        RandomStream random(seed, stream, r);
        runs.estimates[r] = run(n, random);
        seconds[r] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
    for (const double s : seconds) runs.seconds += s / static_cast<double>(count);
    return runs;
}

Estimate mean_of(const Runs& runs) {
    MeanOfRuns mean;
    for (const Estimate& one : runs.estimates) mean.add(one);
    return mean.estimate();
}

bool skewed(const Runs& runs) {
    Moments values;
    for (const Estimate& one : runs.estimates) values.add(one.value);
    constexpr double z = 1.96;
    return std::abs(values.skewness()) * z * z * z > 3 * std::sqrt(static_cast<double>(values.count()));
}

Search search_sample_count(const IndependentRun& run, const ErrorTarget& target, std::uint64_t replicates,
                           std::uint64_t max_evaluations, std::uint64_t seed,
                           const std::function<void(const Runs&)>& progress) {
    constexpr double margin = 2.0 / 3;
    Search search;
    std::uint64_t spent = 0;
    for (std::uint64_t n = 16;; n *= 2) {
        search.looks.push_back(independent_runs(run, n, replicates, seed, "look"));
        if (progress) progress(search.looks.back());
        const Estimate seen = mean_of(search.looks.back());
        search.met = seen.evaluations >= least_evaluations &&
                     seen.standard_error <= margin * target.absolute(seen.value) && !skewed(search.looks.back());
        spent += seen.evaluations;
        if (search.met || spent + 4 * seen.evaluations > max_evaluations) return search;
    }
}

}  // namespace plumb
