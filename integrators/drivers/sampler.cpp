#include "integrators/drivers/sampler.h"

#include "core/error.h"
#include "estimators/points/sobol.h"
#include "estimators/points/stratified.h"

namespace plumb {

namespace {

std::variant<IndependentSamples, PointSetSamples> samples_named(const std::string& name, std::uint32_t n) {
    if (name == "independent") return IndependentSamples();
    if (name == "stratified") return PointSetSamples(stratified_2d, n);
    if (name == "sobol") return PointSetSamples(owen_sobol_2d, n);
    throw unknown_name("sampler", name, sampler_names());
}

}  // namespace

Sampler::Sampler(const std::string& name, std::uint32_t n) : samples_(samples_named(name, n)) {}

PrimarySamples& Sampler::start(const PathKey& key) {
    return std::visit(
        [&](auto& samples) -> PrimarySamples& {
            samples.start(key);
            return samples;
        },
        samples_);
}

std::vector<std::string> sampler_names() {
    return {"independent", "stratified", "sobol"};
}

}  // namespace plumb
