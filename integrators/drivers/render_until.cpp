#include "integrators/drivers/render_until.h"

namespace plumb {

RenderedUntil render_until(RenderJob job, const ErrorTarget& target, std::uint32_t most_passes,
                           const DoublingProgress& hears) {
    const auto go_on = [&](const RenderProgress& at) {
        if (hears.progress) hears.progress(at);
        return true;
    };
    RenderSettings& settings = job.settings;
    settings.passes = std::min(settings.passes, most_passes);
    RenderedUntil result{render(job, go_on)};
    while (true) {
        result.error = error_of(result.rendered.film);
        result.met = meets(result.error, target);
        const auto passes = static_cast<std::uint32_t>(result.rendered.film.replicates());
        if (hears.look) hears.look(passes, result.error);
        if (result.met || passes >= most_passes) return result;
        settings.first_pass = passes;
        settings.passes = std::min(2 * passes, most_passes);
        const Rendered more = render(job, go_on);
        result.rendered.film.merge(more.film);
        result.rendered.rays += more.rays;
    }
}

}  // namespace plumb
