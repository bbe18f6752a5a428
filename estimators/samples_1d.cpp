#include "estimators/samples_1d.h"

namespace plumb {

std::vector<double> independent_samples_1d(std::uint64_t n, RandomStream& random) {
    std::vector<double> samples(n);
    for (double& x : samples) x = random.uniform();
    return samples;
}

std::vector<double> jittered_samples_1d(std::uint64_t n, RandomStream& random) {
    std::vector<double> samples(n);
    for (std::uint64_t i = 0; i < n; ++i)
        samples[i] = std::min((static_cast<double>(i) + random.uniform()) / static_cast<double>(n), 1 - 0x1p-53);
    return samples;
}

}  // namespace plumb
