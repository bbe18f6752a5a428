#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/primary_samples.h"
#include "estimators/points/point_set.h"
#include "estimators/points/point_set_samples.h"

namespace plumb {

/// The samplers of a render: the point sets whose points are each uniform, as `plumb list estimators` names them.
const std::vector<PointSet<2>>& samplers();
/// The sampler of this name; `sobol` is `sobol-owen` in a render, as Sobol's sequence itself is no random set. Throws
/// Error naming the nearest ones.
const PointSet<2>& find_sampler(const std::string& id);

/// The source of a render's random numbers: independent ones, or point sets over the samples of a pixel in a pass.
class Sampler {
public:
    /// A sampler for n samples of a pixel in a pass. Throws Error for an unknown name.
    Sampler(const std::string& id, std::uint32_t n);

    /// The numbers of one path, which hold until the next start().
    PrimarySamples& start(const PathKey& key);

    /// Whether the paths of a pixel in a pass are independent of each other: then their spread gives the error of their
    /// mean.
    [[nodiscard]] bool independent() const { return std::holds_alternative<IndependentSamples>(samples_); }

private:
    std::variant<IndependentSamples, PointSetSamples> samples_;
};

}  // namespace plumb
