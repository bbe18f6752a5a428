#include "estimators/replicates/batches.h"

#include "core/error.h"
#include "estimators/replicates/independent_slope.h"
#include "estimators/replicates/mean_of_runs.h"

namespace plumb {

Estimate mean_of_batches(const IndependentRun& run, std::uint64_t n, std::uint64_t batches, RandomStream& random) {
    if (batches == 0 || batches > n)
        throw Error(fmt::format("{} batches of {} samples; 1 to {} are accepted", batches, n, n));
    MeanOfRuns mean;
    for (std::uint64_t b = 0; b < batches; ++b) mean.add(run(n / batches + (b < n % batches ? 1 : 0), random));
    return mean.estimate();
}

template <int D>
Estimator<D> in_batches_of(std::string id, const Estimator<D>& estimator, std::uint64_t size) {
    if (size == 0) throw Error("batches of 0 samples; at least 1 is accepted");
    auto run = [run = estimator.run, size](const Function<D>& f, std::uint64_t n, RandomStream& random) {
        return mean_of_batches([&](std::uint64_t batch, RandomStream& r) { return run(f, batch, r); }, n,
                               std::max<std::uint64_t>(1, n / size), random);
    };
    Estimator<D> batched{std::move(id),
                         fmt::format("{}, in independent batches of about {}.", estimator.id, size),
                         "[thesis, section 4.5.1]",
                         estimator.unbiased,
                         std::move(run),
                         {}};
    if (estimator.unbiased) batched.expected_slope = independent_slope<D>;
    return batched;
}
template Estimator<1> in_batches_of(std::string, const Estimator<1>&, std::uint64_t);
template Estimator<2> in_batches_of(std::string, const Estimator<2>&, std::uint64_t);

template <int D>
Estimator<D> batches_sharing(std::string id, const Estimator<D>& estimator, std::uint64_t total) {
    auto run = [run = estimator.run, total](const Function<D>& f, std::uint64_t n, RandomStream& random) {
        const std::uint64_t batches = std::max<std::uint64_t>(1, total / n);
        return mean_of_batches([&](std::uint64_t batch, RandomStream& r) { return run(f, batch, r); }, batches * n,
                               batches, random);
    };
    Estimator<D> shared{std::move(id),
                        fmt::format("{}, {} samples in independent batches of n.", estimator.id, total),
                        "[thesis, section 4.5.1]",
                        estimator.unbiased,
                        std::move(run),
                        {}};
    if (estimator.unbiased && estimator.expected_slope)  // the variance of a batch, divided by total/n
        shared.expected_slope = [slope = estimator.expected_slope](const Integrand<D>& f) -> std::optional<Interval> {
            const std::optional<Interval> one = slope(f);
            if (!one) return {};
            return Interval{one->low + 1, one->high + 1};
        };
    return shared;
}
template Estimator<1> batches_sharing(std::string, const Estimator<1>&, std::uint64_t);
template Estimator<2> batches_sharing(std::string, const Estimator<2>&, std::uint64_t);

}  // namespace plumb
