#include "integrators/drivers/render_until.h"

namespace plumb {

namespace {

double choices_of_rarest_light(const RenderJob& job, const Film& film) {
    const double pixels = static_cast<double>(film.size().width) * film.size().height;
    const double samples = pixels * static_cast<double>(film.replicates()) * job.settings.samples_per_pass;
    return samples * job.scene.least_light_chance();
}

}  // namespace

RenderedUntil render_until(RenderJob job, const ErrorTarget& target, std::uint32_t most_passes,
                           const DoublingProgress& hears) {
    const auto passes_to = [&](std::uint32_t first, std::uint32_t end) {
        job.settings.first_pass = first;
        job.settings.passes = end;
        return render(job, [&](const RenderProgress& at) {
            if (hears.progress) hears.progress(at);
            return true;
        });
    };
    std::uint32_t end = std::min(job.settings.passes, most_passes);
    RenderedUntil result{passes_to(0, end / 2)};
    while (true) {
        const auto begin = static_cast<std::uint32_t>(result.rendered.film.replicates());
        const Rendered more = passes_to(begin, end);
        result.grounds.variance_error = error_of_variance(result.rendered.film, more.film);
        result.rendered.film.merge(more.film);
        result.rendered.rays += more.rays;
        result.error = error_of(result.rendered.film);
        result.grounds.choices_of_rarest_light = choices_of_rarest_light(job, result.rendered.film);
        result.met = meets(result.error, target) && result.grounds.trusted();
        if (hears.look) hears.look(end, result.error);
        if (result.met || end >= most_passes) return result;
        end = std::min(2 * end, most_passes);
    }
}

}  // namespace plumb
