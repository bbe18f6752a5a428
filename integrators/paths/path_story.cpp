#include "integrators/paths/path_story.h"

namespace plumb {

void PathStory::found(Finding finding, std::size_t splat) {
    finding.throughput = throughput;
    finding.splat = splat;
    findings.push_back(finding);
}

void PathStory::scattered(const Scattering& scattering) {
    scatterings.push_back(scattering);
}

void PathStory::played(double survival, bool survived) {
    scatterings.back().survival = survival;
    scatterings.back().survived = survived;
}

}  // namespace plumb
