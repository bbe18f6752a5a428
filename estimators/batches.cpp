#include "estimators/batches.h"

#include "core/error.h"
#include "core/moments.h"

namespace plumb {

Estimate mean_of_batches(const IndependentRun& run, std::uint64_t n, std::uint64_t batches, RandomStream& random) {
    if (batches == 0 || batches > n)
        throw Error(fmt::format("{} batches of {} samples; 1 to {} are accepted", batches, n, n));
    Moments moments;
    Estimate mean;
    for (std::uint64_t b = 0; b < batches; ++b) {
        const Estimate batch = run(n / batches + (b < n % batches ? 1 : 0), random);
        moments.add(batch.value);
        mean.evaluations += batch.evaluations;
    }
    mean.value = moments.mean();
    mean.standard_error = moments.standard_error();
    return mean;
}

}  // namespace plumb
