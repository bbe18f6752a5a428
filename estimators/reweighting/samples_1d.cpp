#include "estimators/reweighting/samples_1d.h"

#include "estimators/points/strata.h"

namespace plumb {

std::vector<double> independent_samples_1d(std::uint64_t n, RandomStream& random) {
    std::vector<double> samples(n);
    for (double& x : samples) x = random.uniform();
    return samples;
}

std::vector<double> jittered_samples_1d(std::uint64_t n, RandomStream& random) {
    std::vector<double> samples(n);
    for (std::uint64_t i = 0; i < n; ++i) samples[i] = in_stratum(i, n, random.uniform());
    return samples;
}

}  // namespace plumb
