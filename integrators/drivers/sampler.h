#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/primary_samples.h"
#include "estimators/points/point_set_samples.h"

namespace plumb {

/// Where a render's random numbers come from: independent ones, or point sets over the samples of a pass.
class Sampler {
public:
    /// independent, stratified or sobol (Owen's scrambling), n samples of a pixel a pass. Throws Error for another
    /// name.
    Sampler(const std::string& name, std::uint32_t n);

    /// The numbers of one path, until the next start().
    PrimarySamples& start(const PathKey& key);

private:
    std::variant<IndependentSamples, PointSetSamples> samples_;
};

std::vector<std::string> sampler_names();

}  // namespace plumb
