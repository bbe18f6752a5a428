#include <chrono>
#include <filesystem>

#include "cli/commands.h"
#include "cli/run_info.h"
#include "cli/scene_identity.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "integrators/integrators.h"
#include "integrators/render_until.h"
#include "integrators/sampler.h"
#include "reports/json.h"
#include "scenes/mitsuba_xml.h"
#include "scenes/shipped.h"

namespace plumb {
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

FilmRegion crop_of(const std::vector<int>& crop, FilmSize film) {
    if (crop.empty()) return {0, 0, film.width, film.height};
    return {crop[0], crop[1], crop[2], crop[3]};
}

// Formats that hold floats and names get every layer, the others what a person looks at.
Image fit_for(const fs::path& file, const Image& image) {
    const std::string format = file.extension().string();
    if (format == ".exr" || format == ".tif" || format == ".tiff") return image;
    const bool linear = format == ".hdr" || format == ".pfm";
    const auto srgb = [](float x) {  // [IEC 61966-2-1]
        const float v = std::clamp(x, 0.f, 1.f);
        return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    };
    Image colours{image.width, image.height, {"R", "G", "B"}, {}, image.metadata};
    for (std::size_t i = 0; i < image.values.size(); i += image.channels.size())
        for (std::size_t c = 0; c < 3; ++c)
            colours.values.push_back(linear ? image.values[i + c] : srgb(image.values[i + c]));
    return colours;
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
    Watch(const std::optional<std::chrono::duration<double>>& limit, const std::optional<ErrorTarget>& target)
        : limit_(limit), target_(target) {}

    bool operator()(const RenderProgress& progress) {
        const double spent = seconds();
        const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        const double left = limit_ ? limit_->count() - spent : spent * (1 - share) / share;
        if (seconds_since(shown_) > 0.1) {
            line_.show(limit_ ? fmt::format("{:.0f} s left", std::max(0.0, left))
                              : fmt::format("{:3.0f} %, {:.0f} s left", 100 * share, left));
            shown_ = Clock::now();
        }
        return !limit_ || left > 0;
    }
    // Squared errors fall as 1/passes, and passes double.
    void look(std::uint64_t passes, const FilmError& error) {
        const double share = (target_->relative ? error.relative : error.rmse) / target_->error;
        const double factor = std::exp2(std::ceil(std::log2(std::max(1.0, share * share))));
        line_.show(fmt::format("{} passes, {}, about {:.0f} s left", passes, text_of(error), seconds() * (factor - 1)));
    }
    [[nodiscard]] double seconds() const { return seconds_since(start_); }

private:
    std::optional<std::chrono::duration<double>> limit_;
    std::optional<ErrorTarget> target_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    ProgressLine line_;
};

RenderedUntil rendered(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings,
                       const RenderOptions& options, Watch& watch) {
    if (options.error)
        return render_until(scene, estimator, settings, *options.error,
                            options.most_samples / settings.samples_per_pass,
                            [&](std::uint64_t passes, const FilmError& error) { watch.look(passes, error); });
    Rendered all = render(scene, estimator, settings, std::ref(watch));
    const FilmError error = error_of(all.film);
    return {std::move(all), error, true};
}

std::vector<Field> side_record(const Rendered& rendered, const RunInfo& info) {
    const BadValues& bad = rendered.film.bad_values();
    return {{"started", info.started}, {"seconds", info.seconds}, {"threads", static_cast<std::uint64_t>(info.threads)},
            {"rays", rendered.rays},   {"nan", bad.nan},          {"infinite", bad.infinite},
            {"negative", bad.negative}};
}

void print_bad_values(const BadValues& bad) {
    if (bad == BadValues{}) return;
    fmt::print("values that should not be: {} NaN, {} infinite, {} negative; NaN and infinite ones count as 0\n",
               bad.nan, bad.infinite, bad.negative);
}

}  // namespace

int render(const RenderOptions& options) {
    PathLimits limits{options.max_depth, options.roulette_depth, options.length};
    if (!options.strategy.empty()) limits.strategy = Strategy{options.strategy[0], options.strategy[1]};
    const auto estimator = make_integrator(options.integrator, limits);
    const fs::path file = scene_file(options.scene);
    const fs::path out = options.out.empty() ? fs::path("out") / (scene_name(file) + ".exr") : fs::path(options.out);
    check_writable(out);
    check_image_format(out);
    RunInfo info = start_run(options.seed, options.threads);
    RenderSettings settings{.sampler = options.sampler, .seed = info.seed};
    if (options.time) settings.passes = 1u << 20;
    if (!options.time && !options.error) settings = with_samples(settings, options.samples_per_pixel);
    Sampler(settings.sampler, 1);  // knows the name, or says so before the work begins
    const Scene scene(load_mitsuba(file, {options.definitions, options.lenient}));
    const FilmSize film = scene.sensor().film();
    settings.crop = crop_of(options.crop, film);
    check_crop(settings.crop, film);
    print_notes(scene.description());

    std::optional<RenderedUntil> done;
    {
        Watch watch(options.time, options.error);
        with_threads(info.threads, [&] { done = rendered(scene, *estimator, settings, options, watch); });
        info.seconds = watch.seconds();
    }
    const Rendered& picture = done->rendered;
    const std::uint64_t replicates = picture.film.replicates(), samples = replicates * settings.samples_per_pass;
    Image image = picture.film.image();
    Provenance provenance = identity_of(options.scene, scene.description());
    provenance.integrator = options.integrator;
    provenance.sampler = settings.sampler;
    provenance.limits = limits;
    provenance.seed = info.seed;
    provenance.samples_per_pixel = samples;
    provenance.replicates = replicates;
    provenance.film = film;
    provenance.crop = settings.crop;
    provenance.error = done->error;
    image.metadata = metadata_of(provenance);
    if (out.has_parent_path()) fs::create_directories(out.parent_path());
    write_image(out, fit_for(out, image));
    const std::vector<ListRow> record{side_record(picture, info)};
    write_file(out.string() + ".json", list_json(record));
    print_bad_values(picture.film.bad_values());
    fmt::print("{} samples a pixel, {:.3g} rays, {:.1f} s, seed {}, {}; {}\n", samples,
               static_cast<double>(picture.rays), info.seconds, info.seed, text_of(done->error), out.string());
    if (done->met) return 0;
    fmt::print("the error {} was not reached with {} samples a pixel (--max-spp): fireflies, or too few samples\n",
               text_of(*options.error), samples);
    return 3;
}

}  // namespace plumb
