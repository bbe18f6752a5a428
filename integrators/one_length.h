#pragma once

#include <memory>

#include "integrators/path_estimator.h"

namespace plumb {

/// What another estimator says of paths of one length.
struct OneLength final : PathEstimator {
    std::shared_ptr<const PathEstimator> estimator;
    int edges;

    OneLength(std::shared_ptr<const PathEstimator> of, int length) : estimator(std::move(of)), edges(length) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        estimator->trace(scene, region, samples, record);
        std::erase_if(record.splats, [this](const Splat& splat) { return splat.edges != edges; });
    }
};

}  // namespace plumb
