#include "cli/verbs/render.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "cli/verbs/picture_file.h"
#include "integrators/drivers/render_until.h"
#include "integrators/references/scene_identity.h"
#include "scenes/film/film_part.h"
#include "scenes/shipped/shipped.h"

namespace plumb::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void print_notes(const description::Scene& scene) {
    for (const description::Note& note : scene.notes)
        fmt::print("{}:{}: {} {}\n", note.place.file, note.place.line,
                   note.kind == description::Note::Kind::replaced ? "replaced:" : "not followed:", note.text);
}

// What the picture is a function of.
Provenance provenance(const std::string& scene_name, const RenderMethod& method, const RenderSettings& settings,
                      const Scene& scene) {
    Provenance p = identity_of(scene_name, scene.description());
    p.integrator = method.integrator;
    p.driver = method.driver;
    p.sampler = method.sampler;
    p.parameters = method.parameters;
    p.limits = method.limits;
    p.seed = settings.seed;
    p.samples_per_pixel = std::uint64_t{settings.passes} * settings.samples_per_pass;
    p.replicates = settings.passes;
    p.film = scene.sensor().film();
    p.crop = settings.crop;
    return p;
}

std::string text_of(const FilmError& error) {
    return fmt::format("relative error {:.3g} % (RMSE {:.3g})", 100 * error.relative, error.rmse);
}

std::string text_of(const ErrorTarget& target) {
    return target.relative ? fmt::format("{:.3g} %", 100 * target.error) : fmt::format("RMSE {:.3g}", target.error);
}

// Says how far the render is; ends it when its time is over.
class Watch {
public:
    Watch(const std::optional<std::chrono::duration<double>>& limit, const std::optional<ErrorTarget>& target,
          Session& session)
        : limit_(limit), target_(target), session_(session) {}

    bool operator()(const RenderProgress& progress) {
        const double spent = seconds();
        const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        const double left = limit_ ? limit_->count() - spent : spent * (1 - share) / share;
        if (seconds_since(shown_) > 0.1) {
            session_.show(limit_ ? fmt::format("{:.0f} s left", std::max(0.0, left))
                                 : fmt::format("{:3.0f} %, {:.0f} s left", 100 * share, left));
            shown_ = Clock::now();
        }
        return !limit_ || left > 0;
    }
    // Squared errors fall as 1/passes, and passes double.
    void look(std::uint64_t passes, const FilmError& error) {
        const double share = (target_->relative ? error.relative : error.rmse) / target_->error;
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
    std::optional<std::chrono::duration<double>> limit_;
    std::optional<ErrorTarget> target_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    std::string found_;
    Session& session_;
};

RenderedUntil rendered(const RenderJob& job, const RenderOptions& options, Watch& watch) {
    if (options.error)
        return render_until(job, *options.error, options.most_samples / job.settings.samples_per_pass,
                            {[&](std::uint64_t passes, const FilmError& error) { watch.look(passes, error); },
                             [&](const RenderProgress& progress) { watch.double_passes(progress); }});
    Rendered all = render(job, std::ref(watch));
    const FilmError error = error_of(all.film);
    return {std::move(all), error, true};
}

std::vector<Field> side_record(const Rendered& rendered, const reports::RunInfo& info) {
    std::vector<Field> record{{"started", info.started},
                              {"seconds", info.seconds},
                              {"threads", static_cast<std::uint64_t>(info.threads)},
                              {"rays", rendered.rays}};
    for (Field& field : bad_values_of(rendered.film)) record.push_back(std::move(field));
    return record;
}

fs::path output_of(const RenderOptions& options, const fs::path& scene) {
    if (!options.out.empty()) return options.out;
    const std::string name = scene_name(scene);
    const auto& shard = options.shard;
    return fs::path("out") /
           (shard ? fmt::format("{}-{}-of-{}.film", name, shard->index, shard->count) : name + ".exr");
}

}  // namespace

CLI::Option* add_error(CLI::App& verb, RenderOptions& options) {
    CLI::Option* error = add_parsed(verb, "--error", options.error, parse_error_target,
                                    "double the passes until the picture's RMSE is at most this, 1e-3, or 1% of the "
                                    "picture");
    verb.add_option("--max-spp", options.most_samples, "samples of each pixel at which --error gives up")
        ->check(CLI::Range(64u, 1u << 24))
        ->needs(error)
        ->capture_default_str();
    return error;
}

int render(const RenderOptions& options, const std::function<Scene()>& load) {
    const RenderMethod method = method_of(options);
    const auto estimator = estimator_of(method);
    const fs::path file = scene_file(options.scene);
    const fs::path out = output_of(options, file);
    require_writable({out});
    if (!options.shard) check_image_format(out);
    Session session(options.seed, options.threads);
    const reports::RunInfo& info = session.run;
    const Scene scene = load();
    RenderSettings settings = settings_of(options, info.seed, scene.sensor().film());
    if (options.time) settings.passes = 1u << 20;
    if (options.shard) settings = part_of(settings, options.shard->index, options.shard->count);
    print_notes(scene.description());

    std::optional<RenderedUntil> done;
    Watch watch(options.time, options.error, session);
    session.work([&] { done = rendered(job_of(method, scene, *estimator, settings), options, watch); });
    const auto& [picture, error, met] = *done;
    if (options.time || options.error) settings.passes = static_cast<std::uint32_t>(picture.film.replicates());
    const auto of = metadata_of(provenance(options.scene, method, settings, scene));
    if (options.shard)
        write_film_part(out, {of, static_cast<std::uint32_t>(options.shard->index),
                              static_cast<std::uint32_t>(options.shard->count), picture.rays, picture.film});
    else
        write_picture(out, picture.film, of);
    write_side_record(out, side_record(picture, info));
    print_bad_values(picture.film.bad_values());
    const std::uint64_t samples = picture.film.replicates() * settings.samples_per_pass;
    fmt::print("{} samples a pixel, {:.3g} rays, {:.1f} s, seed {}, {}; {}\n", samples,
               static_cast<double>(picture.rays), info.seconds, info.seed, text_of(error), out.string());
    if (met) return 0;
    fmt::print("the error {} was not reached with {} samples a pixel (--max-spp): fireflies, or too few samples\n",
               text_of(*options.error), samples);
    return 3;
}

namespace verbs {
namespace {

Action add(CLI::App& verb) {
    const auto options = std::make_shared<RenderOptions>();
    add_paths(verb, *options);
    CLI::Option* spp = verb.get_option("--spp");
    CLI::Option* time = add_parsed(verb, "--time", options->time, parse_duration,
                                   "instead of --spp: render as many passes of 4 samples as fit into, e.g., 30s")
                            ->excludes(spp);
    CLI::Option* error = add_error(verb, *options)->excludes(spp)->excludes(time);
    add_seed_and_threads(verb, options->seed, options->threads);
    add_parsed(
        verb, "--shard", options->shard, parse_shard,
        "render every n-th pass from the i-th on, i/n, into a part of a film; plumb merge joins them. Needs --seed")
        ->needs(verb.get_option("--seed"))
        ->excludes(time)
        ->excludes(error);
    verb.add_option("-o,--output", options->out,
                    "the image, in a format that OpenImageIO writes; EXR and TIFF keep all layers [out/SCENE.exr]");
    verb.footer(
        "Exit code: 0, or 3 when --error was not reached, 2 usage or input error.\n\n"
        "Examples: plumb render cornell_box --sampler sobol --spp 64 -o cornell.exr\n"
        "          plumb render cornell_box --integrator path --error 2%");
    return [options](const Catalogue&) { return cli::render(*options, [&] { return load_scene(*options); }); };
}

}  // namespace

Verb render() {
    return {"render", "Render a scene to an image with its variance", add};
}

}  // namespace verbs
}  // namespace plumb::cli
