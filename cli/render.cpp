#include <chrono>
#include <filesystem>

#include "cli/commands.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "integrators/integrators.h"
#include "integrators/render.h"
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

// Scenes often lie in a folder of their own name, as scene.xml.
std::string name_of(const fs::path& file) {
    return file.stem() == "scene" ? fs::absolute(file).parent_path().filename().string() : file.stem().string();
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

// What the picture is a function of: no dates, no seconds, so that the same seed gives the same file.
std::map<std::string, std::string> metadata(const RenderOptions& options, const fs::path& file,
                                            const RenderSettings& settings, const Scene& scene, const Film& film,
                                            const RunInfo& info) {
    const FilmRegion& crop = settings.crop;
    return {{"plumb:scene", name_of(file)},
            {"plumb:scene_hash", fmt::format("{:016x}", scene.description().content_hash)},
            {"plumb:integrator", options.integrator},
            {"plumb:sampler", settings.sampler},
            {"plumb:max_depth", fmt::format("{}", options.max_depth)},
            {"plumb:seed", fmt::format("{}", settings.seed)},
            {"plumb:spp", fmt::format("{}", film.replicates() * settings.samples_per_pass)},
            {"plumb:replicates", fmt::format("{}", film.replicates())},
            {"plumb:film", fmt::format("{}x{}", scene.sensor().film().width, scene.sensor().film().height)},
            {"plumb:crop", fmt::format("{},{},{},{}", crop.x, crop.y, crop.width, crop.height)},
            {"Software", fmt::format("Plumb {}", info.version)}};
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

// Says how far the render is; ends it when its time is over.
class Watch {
public:
    explicit Watch(const std::optional<std::chrono::duration<double>>& limit) : limit_(limit) {}

    bool operator()(const RenderProgress& progress) {
        const double spent = seconds_since(start_);
        const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        const double left = limit_ ? limit_->count() - spent : spent * (1 - share) / share;
        if (seconds_since(shown_) > 0.1) {
            line_.show(limit_ ? fmt::format("{:.0f} s left", std::max(0.0, left))
                              : fmt::format("{:3.0f} %, {:.0f} s left", 100 * share, left));
            shown_ = Clock::now();
        }
        return !limit_ || left > 0;
    }
    [[nodiscard]] double seconds() const { return seconds_since(start_); }

private:
    std::optional<std::chrono::duration<double>> limit_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    ProgressLine line_;
};

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
    const fs::path out = options.out.empty() ? fs::path("out") / (name_of(file) + ".exr") : fs::path(options.out);
    check_writable(out);
    check_image_format(out);
    RunInfo info = start_run(options.seed, options.threads);
    RenderSettings settings{.sampler = options.sampler, .seed = info.seed};
    if (options.time)
        settings.passes = 1u << 20;
    else
        settings = with_samples(settings, options.samples_per_pixel);
    Sampler(settings.sampler, 1);  // knows the name, or says so before the work begins
    const Scene scene(load_mitsuba(file, {options.definitions, options.lenient}));
    settings.crop = crop_of(options.crop, scene.sensor().film());
    check_crop(settings.crop, scene.sensor().film());
    print_notes(scene.description());

    std::optional<Rendered> rendered;
    {
        Watch watch(options.time);
        with_threads(info.threads, [&] { rendered = render(scene, *estimator, settings, std::ref(watch)); });
        info.seconds = watch.seconds();
    }
    Image image = rendered->film.image();
    image.metadata = metadata(options, file, settings, scene, rendered->film, info);
    if (out.has_parent_path()) fs::create_directories(out.parent_path());
    write_image(out, fit_for(out, image));
    const std::vector<ListRow> record{side_record(*rendered, info)};
    write_file(out.string() + ".json", list_json(record));
    print_bad_values(rendered->film.bad_values());
    const std::uint64_t samples = rendered->film.replicates() * settings.samples_per_pass;
    fmt::print("{} samples a pixel, {:.3g} rays, {:.1f} s, seed {}; {}\n", samples, static_cast<double>(rendered->rays),
               info.seconds, info.seed, out.string());
    return 0;
}

}  // namespace plumb
