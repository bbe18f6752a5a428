#include "integrators/drivers/render_until.h"

namespace plumb {

RenderedUntil render_until(const Scene& scene, const PathEstimator& estimator, RenderSettings settings,
                           const ErrorTarget& target, std::uint32_t most_passes,
                           const std::function<void(std::uint64_t passes, const FilmError&)>& look,
                           const std::function<void(const RenderProgress&)>& progress) {
    const auto go_on = [&](const RenderProgress& at) {
        if (progress) progress(at);
        return true;
    };
    settings.passes = std::min(settings.passes, most_passes);
    RenderedUntil result{render(scene, estimator, settings, go_on)};
    while (true) {
        result.error = error_of(result.rendered.film);
        result.met = meets(result.error, target);
        const auto passes = static_cast<std::uint32_t>(result.rendered.film.replicates());
        if (look) look(passes, result.error);
        if (result.met || passes >= most_passes) return result;
        settings.first_pass = passes;
        settings.passes = std::min(2 * passes, most_passes);
        const Rendered more = render(scene, estimator, settings, go_on);
        result.rendered.film.merge(more.film);
        result.rendered.rays += more.rays;
    }
}

}  // namespace plumb
