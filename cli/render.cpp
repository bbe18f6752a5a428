#include <chrono>
#include <filesystem>

#include "cli/commands.h"
#include "cli/path_options.h"
#include "cli/picture_file.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "scenes/film_part.h"
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

// What the picture is a function of: no dates, no seconds, so that the same seed gives the same file.
std::map<std::string, std::string> metadata(const RenderOptions& options, const fs::path& file,
                                            const RenderSettings& settings, const Scene& scene, const RunInfo& info) {
    const FilmRegion& crop = settings.crop;
    std::map<std::string, std::string> of{
        {"plumb:scene", name_of(file)},
        {"plumb:scene_hash", fmt::format("{:016x}", scene.description().content_hash)},
        {"plumb:integrator", options.integrator},
        {"plumb:sampler", settings.sampler},
        {"plumb:max_depth", fmt::format("{}", options.max_depth)},
        {"plumb:rr_depth", fmt::format("{}", options.roulette_depth)},
        {"plumb:seed", fmt::format("{}", settings.seed)},
        {"plumb:spp", fmt::format("{}", settings.passes * settings.samples_per_pass)},
        {"plumb:replicates", fmt::format("{}", settings.passes)},
        {"plumb:film", fmt::format("{}x{}", scene.sensor().film().width, scene.sensor().film().height)},
        {"plumb:crop", fmt::format("{},{},{},{}", crop.x, crop.y, crop.width, crop.height)},
        {"Software", fmt::format("Plumb {}", info.version)}};
    if (options.length > 0) of["plumb:length"] = fmt::format("{}", options.length);
    if (!options.strategy.empty())
        of["plumb:strategy"] = fmt::format("{},{}", options.strategy[0], options.strategy[1]);
    return of;
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
    std::vector<Field> record{{"started", info.started},
                              {"seconds", info.seconds},
                              {"threads", static_cast<std::uint64_t>(info.threads)},
                              {"rays", rendered.rays}};
    for (Field& field : bad_values_of(rendered.film)) record.push_back(std::move(field));
    return record;
}

fs::path output_of(const RenderOptions& options, const fs::path& scene) {
    if (!options.out.empty()) return options.out;
    const std::string name = name_of(scene);
    const auto& shard = options.shard;
    return fs::path("out") /
           (shard ? fmt::format("{}-{}-of-{}.film", name, shard->index, shard->count) : name + ".exr");
}

}  // namespace

int render(const RenderOptions& options) {
    const auto estimator = estimator_of(options);
    const fs::path file = scene_file(options.scene);
    const fs::path out = output_of(options, file);
    check_writable(out);
    if (!options.shard) check_image_format(out);
    RunInfo info = start_run(options.seed, options.threads);
    const Scene scene = load_scene(options);
    RenderSettings settings = settings_of(options, info.seed, scene.sensor().film());
    if (options.time) settings.passes = 1u << 20;
    if (options.shard) settings = part_of(settings, options.shard->index, options.shard->count);
    print_notes(scene.description());

    std::optional<Rendered> rendered;
    {
        Watch watch(options.time);
        with_threads(info.threads, [&] { rendered = render(scene, *estimator, settings, std::ref(watch)); });
        info.seconds = watch.seconds();
    }
    const auto passes = static_cast<std::uint32_t>(rendered->film.replicates());
    if (options.time) settings.passes = passes;
    const auto of = metadata(options, file, settings, scene, info);
    if (options.shard)
        write_film_part(out, {of, static_cast<std::uint32_t>(options.shard->index),
                              static_cast<std::uint32_t>(options.shard->count), rendered->rays, rendered->film});
    else
        write_picture(out, rendered->film, of);
    write_side_record(out, side_record(*rendered, info));
    print_bad_values(rendered->film.bad_values());
    fmt::print("{} samples a pixel, {:.3g} rays, {:.1f} s, seed {}; {}\n", passes * settings.samples_per_pass,
               static_cast<double>(rendered->rays), info.seconds, info.seed, out.string());
    return 0;
}

}  // namespace plumb
