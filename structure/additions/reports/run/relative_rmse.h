#pragma once

#include <algorithm>
#include <cmath>

#include "reports/run/metric.h"

namespace plumb::reports {

/// √MSE / |I|.
inline Measured relative_rmse(const ConvergencePoint& point, double truth, double) {
    const auto relative = [&](double mse) { return std::sqrt(std::max(mse, 0.0)) / std::abs(truth); };
    return {relative(point.mse), relative(point.mse_interval.low), relative(point.mse_interval.high)};
}

}  // namespace plumb::reports
