#include "integrators/paths/limits.h"

#include <algorithm>

namespace plumb {

double survive_by_throughput(const Spectrum& throughput, double eta_squared) {
    return std::min(0.95, largest(throughput) * eta_squared);
}

}  // namespace plumb
