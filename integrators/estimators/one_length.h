#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// The paths of one length that another estimator makes.
struct OneLength final : PathEstimator {
    std::shared_ptr<const PathEstimator> estimator;
    int edges;

    OneLength(std::shared_ptr<const PathEstimator> of, int length) : estimator(std::move(of)), edges(length) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        estimator->trace(scene, region, samples, record);
        if (record.story) tell(*record.story, record.splats);
        std::erase_if(record.splats, [this](const Splat& splat) { return splat.edges != edges; });
    }

private:
    // Findings go with their splats.
    void tell(PathStory& story, const std::vector<Splat>& splats) const {
        std::erase_if(story.findings, [this](const auto& finding) { return finding.strategy.edges() != edges; });
        for (PathStory::Finding& finding : story.findings) {
            const auto before = std::span(splats).first(finding.splat);
            finding.splat = static_cast<std::size_t>(std::ranges::count(before, edges, &Splat::edges));
        }
    }
};

}  // namespace plumb
