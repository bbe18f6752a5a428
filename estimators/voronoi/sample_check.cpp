#include "estimators/voronoi/sample_check.h"

#include <fmt/format.h>

#include "core/error.h"

namespace plumb {

template <int D>
void check_samples(std::span<const Point<D>> samples) {
    if (samples.empty()) throw Error("no samples: Voronoi cells need at least one");
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (int axis = 0; axis < D; ++axis)
            if (const double x = samples[i][axis]; !(0 <= x && x <= 1))
                throw Error(fmt::format("sample {}: coordinate {} is {}; accepted are 0 to 1", i, axis, x));
}
template void check_samples<1>(std::span<const Point<1>>);
template void check_samples<2>(std::span<const Point<2>>);

}  // namespace plumb
