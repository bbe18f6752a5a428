#include "verification/evidence/order.h"

#include <fmt/format.h>

#include "verification/evidence/deterministic.h"

namespace plumb {

Verdict never_falls(std::span<const double> values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(values[i] >= values[i - 1]))
            return exactly(false, values.size(),
                           fmt::format("value {} is {}, that before it {}", i, values[i], values[i - 1]));
    return exactly(true, values.size(), fmt::format("none of {} values is below the one before it", values.size()));
}

}  // namespace plumb
