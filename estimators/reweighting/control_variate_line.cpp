#include "estimators/reweighting/control_variate_line.h"

#include <cmath>

#include "core/error.h"
#include "estimators/reweighting/reweighting_1d.h"

namespace plumb {

EndpointLine endpoint_line(const Function<1>& f) {
    const EndpointLine line{f({0.0}), f({1.0})};
    if (!std::isfinite(line.at_0))
        throw Error(fmt::format("the integrand is {} at 0; the line through its ends needs finite values", line.at_0));
    if (!std::isfinite(line.at_1))
        throw Error(fmt::format("the integrand is {} at 1; the line through its ends needs finite values", line.at_1));
    return line;
}

Estimate control_variate_estimate_1d(const Function<1>& f, std::span<const double> samples) {
    const EndpointLine line = endpoint_line(f);
    const std::vector<double> weights = reweighted_weights_1d(samples);
    Estimate estimate{.value = line.integral(), .evaluations = samples.size() + 2};
    for (std::size_t i = 0; i < samples.size(); ++i)
        estimate.value += weights[i] * (f({samples[i]}) - line(samples[i]));
    return estimate;
}

}  // namespace plumb
