#include "integrators/drivers/sampler.h"

#include "core/named.h"

namespace plumb {

namespace {

std::variant<IndependentSamples, PointSetSamples> samples_of(const PointSet<2>& set, std::uint32_t n) {
    if (set.independent) return IndependentSamples();
    return PointSetSamples(set.generate, n);
}

}  // namespace

const std::vector<PointSet<2>>& samplers() {
    static const std::vector<PointSet<2>> randomised = [] {
        std::vector<PointSet<2>> sets;
        for (const PointSet<2>& set : point_sets_2d())
            if (set.randomised) sets.push_back(set);
        return sets;
    }();
    return randomised;
}

const PointSet<2>& find_sampler(const std::string& id) {
    return find_named(samplers(), id == "sobol" ? "sobol-owen" : id, "sampler");
}

Sampler::Sampler(const std::string& id, std::uint32_t n) : samples_(samples_of(find_sampler(id), n)) {}

PrimarySamples& Sampler::start(const PathKey& key) {
    return std::visit(
        [&](auto& samples) -> PrimarySamples& {
            samples.start(key);
            return samples;
        },
        samples_);
}

}  // namespace plumb
