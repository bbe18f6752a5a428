#pragma once

#include "core/estimate.h"
#include "core/moments.h"

namespace plumb {

/// The mean of independent runs of one method, the standard error of that mean from their spread (its square is
/// unbiased for the variance of the mean), all evaluations counted. The error is infinite, that is unknown, for fewer
/// than two runs and when all runs gave the same value: a deterministic point set repeated shows no spread, and no
/// spread seen says nothing.
class MeanOfRuns {
public:
    void add(const Estimate& run) {
        values_.add(run.value);
        evaluations_ += run.evaluations;
    }

    [[nodiscard]] Estimate estimate() const {
        Estimate mean{.value = values_.mean(), .evaluations = evaluations_};
        if (values_.variance() > 0) mean.standard_error = values_.standard_error();
        return mean;
    }

private:
    Moments values_;
    std::uint64_t evaluations_ = 0;
};

}  // namespace plumb
