#include "integrators/method.h"

#include <fmt/format.h>

#include "integrators/drivers/drivers.h"
#include "integrators/drivers/sampler.h"
#include "integrators/integrators.h"

namespace plumb {

std::vector<Parameter> parameters_of(const RenderMethod& method) {
    std::vector<Parameter> all = find_integrator(method.integrator).parameters;
    const std::vector<Parameter>& of_driver = find_driver(method.driver).parameters;
    all.insert(all.end(), of_driver.begin(), of_driver.end());
    return all;
}

RenderMethod resolved(RenderMethod method) {
    method.sampler = find_sampler(method.sampler).id;
    const std::vector<Parameter> accepted = parameters_of(method);
    require_known(method.parameters, accepted);
    // --rr-depth is an older name of roulette-start.
    const std::string roulette = "roulette-start";
    const Parameters values(accepted, method.parameters);
    ParameterTexts texts = values.texts();
    if (values.given(roulette))
        method.limits.roulette_edges = static_cast<int>(values.integer(roulette));
    else if (texts.contains(roulette))
        texts[roulette] = fmt::format("{}", method.limits.roulette_edges);
    method.parameters = std::move(texts);
    static_cast<void>(estimator_of(method));  // or says which limits it has not
    return method;
}

std::unique_ptr<PathEstimator> estimator_of(const RenderMethod& method) {
    return make_integrator(method.integrator, method.limits, method.parameters);
}

RenderJob job_of(const RenderMethod& method, const Scene& scene, const PathEstimator& estimator,
                 const RenderSettings& settings) {
    RenderJob job{scene, estimator, settings};
    job.settings.sampler = method.sampler;
    const NamedDriver& driver = find_driver(method.driver);
    job.driver = driver.make(job, Parameters(driver.parameters, method.parameters));
    return job;
}

}  // namespace plumb
