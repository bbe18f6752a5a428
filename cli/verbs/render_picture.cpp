#include "cli/verbs/render_picture.h"

#include <cmath>

#include "cli/verbs/picture_file.h"
#include "integrators/drivers/render_until.h"
#include "integrators/drivers/sampler.h"
#include "integrators/references/scene_identity.h"
#include "scenes/film/film_part.h"

namespace plumb::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void print_notes(const description::Scene& scene) {
    for (const description::Note& note : scene.notes)
        fmt::print("{}:{}: {} {}\n", note.place.file, note.place.line,
                   note.kind == description::Note::Kind::replaced ? "replaced:" : "not followed:", note.text);
}

// What a sampler makes sets of: its points are no better than independent ones where a pass has but one.
void print_sets(const PictureTask& task) {
    const PointSet<2>& sampler = find_sampler(task.method.sampler);
    const RenderSettings& settings = task.settings;
    const std::uint32_t points = settings.samples_per_pass, asked = task.samples_asked;
    if (sampler.independent) return;
    if (points == 1)
        fmt::print("{}: {} of a pixel cannot be cut into passes of sets of points: they are independent\n", sampler.id,
                   asked == 1 ? "1 sample" : fmt::format("{} samples", asked));
    else if (asked > 0)
        fmt::print("{}: {} passes of {} points a pixel{}\n", sampler.id, settings.passes, points,
                   asked == settings.passes * points
                       ? ""
                       : fmt::format(" each, {} samples: {} cannot be cut into passes of sets",
                                     settings.passes * points, asked));
    else
        fmt::print("{}: passes of {} points a pixel, independent of each other\n", sampler.id, points);
}

// What the picture is a function of.
Provenance provenance(const LoadedScene& scene, const RenderMethod& method, const RenderSettings& settings) {
    Provenance p = identity_of(scene);
    p.integrator = method.integrator;
    p.driver = method.driver;
    p.sampler = method.sampler;
    p.parameters = method.parameters;
    p.limits = method.limits;
    p.seed = settings.seed;
    p.samples_per_pixel = std::uint64_t{settings.passes} * settings.samples_per_pass;
    p.replicates = settings.passes;
    p.film = scene.scene.sensor().film();
    p.crop = settings.crop;
    return p;
}

std::string text_of(const FilmError& error) {
    return fmt::format("relative error {:.3g} % (RMSE {:.3g})", 100 * error.relative, error.rmse);
}

std::string text_of(const ErrorTarget& target) {
    return target.relative ? fmt::format("{:.3g} %", 100 * target.error) : fmt::format("RMSE {:.3g}", target.error);
}

std::string outcome_of(const FilmError& error, const ErrorTarget& target) {
    const std::string text = text_of(target);
    return meets(error, target) ? fmt::format("undecided whether the error {} was reached", text)
                                : fmt::format("the error {} was not reached", text);
}

// Why a target was not met: by what the picture's error rests on, or by the error itself.
std::string reason_of(const ErrorGrounds& grounds) {
    if (grounds.light_may_be_missing())
        return fmt::format("a light that is expected to be sampled {:.2g} times may be missing",
                           grounds.choices_of_rarest_light);
    if (grounds.few_carry_much())
        return fmt::format("few paths carry much: the variance is known to {:.0f} % only",
                           100 * grounds.variance_error);
    return "too few samples";
}

// Says how far the render is; ends it when its time is over.
class Watch {
public:
    Watch(const RenderEnd& end, Session& session) : end_(end), session_(session) {}

    bool operator()(const RenderProgress& progress) {
        const double spent = seconds();
        const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        const double left = end_.time ? end_.time->count() - spent : spent * (1 - share) / share;
        if (seconds_since(shown_) > 0.1) {
            session_.show(end_.time ? fmt::format("{:.0f} s left", std::max(0.0, left))
                                    : fmt::format("{:3.0f} %, {:.0f} s left", 100 * share, left));
            shown_ = Clock::now();
        }
        return !end_.time || left > 0;
    }
    // Squared errors fall as 1/passes, and passes double.
    void look(std::uint64_t passes, const FilmError& error) {
        const double share = (end_.error->relative ? error.relative : error.rmse) / end_.error->error;
        const double factor = std::exp2(std::ceil(std::log2(std::max(1.0, share * share))));
        found_ = fmt::format("{} passes, {}", passes, text_of(error));
        if (std::isfinite(factor)) found_ += fmt::format(", about {:.0f} s left", seconds() * (factor - 1));
        session_.show(found_);
    }
    void double_passes(const RenderProgress& progress) {
        if (seconds_since(shown_) <= 0.1) return;
        const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        session_.show(fmt::format("{}{}next look: {:3.0f} %", found_, found_.empty() ? "" : "; ", 100 * share));
        shown_ = Clock::now();
    }
    [[nodiscard]] double seconds() const { return seconds_since(start_); }

private:
    RenderEnd end_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    std::string found_;
    Session& session_;
};

RenderedUntil rendered(const RenderJob& job, const RenderEnd& end, Watch& watch) {
    if (end.error)
        return render_until(job, *end.error, end.most_samples / job.settings.samples_per_pass,
                            {[&](std::uint64_t passes, const FilmError& error) { watch.look(passes, error); },
                             [&](const RenderProgress& progress) { watch.double_passes(progress); }});
    Rendered all = render(job, std::ref(watch));
    const FilmError error = error_of(all.film);
    return {std::move(all), error, {}, true};
}

std::vector<Field> side_record(const Rendered& rendered, const reports::RunInfo& info) {
    std::vector<Field> record{{"started", info.started},
                              {"seconds", info.seconds},
                              {"threads", static_cast<std::uint64_t>(info.threads)},
                              {"rays", rendered.rays}};
    for (Field& field : bad_values_of(rendered.film)) record.push_back(std::move(field));
    return record;
}

// The whole picture with its layers, or a part of a film.
void write_rendered(const PictureTask& task, const Rendered& rendered) {
    RenderSettings settings = task.settings;
    if (task.end.time || task.end.error) settings.passes = static_cast<std::uint32_t>(rendered.film.replicates());
    const auto of = metadata_of(provenance(task.scene, task.method, settings));
    if (task.shard)
        write_film_part(task.out, {of, static_cast<std::uint32_t>(task.shard->index),
                                   static_cast<std::uint32_t>(task.shard->count), rendered.rays, rendered.film});
    else
        write_picture(task.out, rendered.film, of);
}

}  // namespace

int render_picture(const PictureTask& task, Session& session) {
    const Scene& scene = task.scene.scene;
    print_notes(scene.description());
    print_sets(task);
    const auto estimator = estimator_of(task.method);
    std::optional<RenderedUntil> done;
    Watch watch(task.end, session);
    session.work([&] { done = rendered(job_of(task.method, scene, *estimator, task.settings), task.end, watch); },
                 fmt::format("nothing is saved; {} is as it was", task.out.string()));

    const auto& [picture, error, grounds, met] = *done;
    const reports::RunInfo& info = session.run;
    write_rendered(task, picture);
    write_side_record(task.out, side_record(picture, info));
    print_bad_values(picture.film.bad_values());
    const std::uint64_t samples = picture.film.replicates() * task.settings.samples_per_pass;
    fmt::print("{} samples a pixel, {:.3g} rays, {:.1f} s, seed {}, {}; {}\n", samples,
               static_cast<double>(picture.rays), info.seconds, info.seed, text_of(error), task.out.string());
    if (met) return 0;
    fmt::print("{} with {} samples a pixel (--max-spp): {}\n", outcome_of(error, *task.end.error), samples,
               reason_of(grounds));
    return 3;
}

}  // namespace plumb::cli
