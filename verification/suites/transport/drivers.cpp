// Drivers on trial: each pass is an unbiased picture, passes are independent, the same bits on any threads and shards.

#include <atomic>

#include "core/parallel.h"
#include "integrators/drivers/frameless.h"
#include "integrators/drivers/render.h"
#include "integrators/drivers/tiles.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/suites/suites.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

constexpr double share = 0.3;  // of 16 pixels: 5, which is 0.3125 of them

/// Frameless rendering that draws its pixels by another rule.
struct DrawnBy final : Driver {
    using Rule = std::function<DrawnPixels(const Frameless&, const RenderJob&, std::uint32_t pass, std::size_t tile)>;
    Frameless right{share};
    Rule rule;

    explicit DrawnBy(Rule r) : rule(std::move(r)) {}
    [[nodiscard]] std::size_t pieces(const RenderJob& job) const override { return right.pieces(job); }
    void make(const RenderJob& job, std::uint32_t pass, std::size_t piece, PassImage& image) const override {
        make_drawn(job, pass, tile_of(job.settings.crop, piece), rule(right, job, pass, piece), image);
    }
    [[nodiscard]] std::optional<double> weight(const RenderJob&, std::uint32_t, int, int) const override { return {}; }
};

using Subject = std::shared_ptr<const Driver>;

Subject frameless() {
    return std::make_shared<Frameless>(share);
}
Subject drawn_by(DrawnBy::Rule rule) {
    return std::make_shared<DrawnBy>(std::move(rule));
}

// ---- means

/// The mean of a picture in which pixels count from ½ to 1½, row by row: it sees who is preferred.
double ramp_mean(const Film& film) {
    const int width = film.size().width, count = width * film.size().height;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += film.mean(i % width, i / width, 0) * (0.5 + (i + 0.5) / count) / count;
    return sum;
}

struct Tracing {
    std::string name;
    std::shared_ptr<const PathEstimator> estimator;
    double delta;  ///< relative
};

// Inside of the sphere every path from the sensor brings the same, 7/8 in all; one from the light lands on few pixels.
Verdict unbiased(const Subject& driver, const Run& run) {
    const PathLimits limits{.max_edges = 4, .roulette_edges = 4};
    const std::array<Tracing, 2> ways{{{"path", std::make_shared<PathTracer>(limits), run.pick(0.02, 0.005)},
                                       {"light", std::make_shared<LightTracer>(limits), run.pick(0.1, 0.02)}}};
    const Scene& scene = sphere_around_point();
    constexpr double reference = 7.0 / 8;
    std::vector<Verdict> parts;
    for (const auto& [name, estimator, delta] : ways) {
        const auto draw = [&, &traced = *estimator](RandomStream& random) {
            const RenderSettings settings{
                .samples_per_pass = 1, .passes = 1, .seed = random.bits(), .crop = {0, 0, 4, 4}};
            return ramp_mean(render({scene, traced, settings, driver}).film);
        };
        parts.push_back(mean_is(draw,
                                {.reference = reference,
                                 .delta = delta * reference,
                                 .epsilon = 1e-5 * reference,
                                 .why_fewer = "closed: every path brings light",
                                 .cap = run.pick(std::uint64_t{1} << 16, std::uint64_t{1} << 20)},
                                run.part(name, 0.5)));
    }
    return all_of(std::move(parts));
}

DrawnPixels undivided(const Frameless& right, const RenderJob& job, std::uint32_t pass, std::size_t tile) {
    return {right.drawn(job, pass, tile).pixels, 1};
}
DrawnPixels divided_by_the_share(const Frameless& right, const RenderJob& job, std::uint32_t pass, std::size_t tile) {
    return {right.drawn(job, pass, tile).pixels, 1 / share};
}
DrawnPixels in_order_at_times(const Frameless& right, const RenderJob& job, std::uint32_t pass, std::size_t tile) {
    DrawnPixels first = right.drawn(job, pass, tile);
    if (job.settings.seed % 6 != 0) return first;
    for (std::uint32_t i = 0; i < first.pixels.size(); ++i) first.pixels[i] = i;
    return first;
}

void add_means(Catalogue& catalogue) {
    catalogue.add(
        {.id = "render/frameless/unbiased",
         .statement = "A pass that draws 5 of 16 pixels has the mean of a picture of all, by `path` and by `light`.",
         .source = "ours, integrators/drivers/frameless.h",
         .kind = Kind::mean,
         .trial = {unbiased,
                   frameless(),
                   {{"undivided", "Samples are not divided by the probability of their pixel.", drawn_by(undivided)},
                    {"by-the-share", "They are divided by the share that was asked for, 0.3, not by 5/16.",
                     drawn_by(divided_by_the_share)},
                    {"in-order", "One picture in six is drawn from the first pixels of the tile.",
                     drawn_by(in_order_at_times)}}}});
}

// ---- the variance layer

/// E[(a − b)²]/2 of two pictures is the variance of one: against what their layers say, summed over pixels, in units of
/// what a pixel's selection alone brings.
Verdict layer_is_spread(const Subject& driver, const Run& run) {
    const PathTracer path({.max_edges = 3, .roulette_edges = 3});
    const auto picture = [&](std::uint64_t seed) {
        const RenderSettings settings{.samples_per_pass = 1, .passes = 2, .seed = seed, .crop = {0, 0, 4, 4}};
        return render({sphere_around_point(), path, settings, driver}).film;
    };
    constexpr double value = 3.0 / 4, p = 5.0 / 16, unit = 16 * value * value * (1 / p - 1) / 2;
    const auto draw = [&](RandomStream& random) {
        const Film a = picture(random.bits()), b = picture(random.bits());
        double sum = 0;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const double difference = a.mean(x, y, 0) - b.mean(x, y, 0);
                sum += (difference * difference - a.variance_of_mean(x, y, 0) - b.variance_of_mean(x, y, 0)) / 2;
            }
        return sum / unit;
    };
    return mean_is(draw,
                   {.delta = run.pick(0.15, 0.03),
                    .epsilon = 1e-9,
                    .why_fewer = "closed: every path brings light",
                    .cap = run.pick(std::uint64_t{1} << 17, std::uint64_t{1} << 20)},
                   run);
}

DrawnPixels same_pixels(const Frameless& right, const RenderJob& job, std::uint32_t, std::size_t tile) {
    return right.drawn(job, 0, tile);
}
DrawnPixels same_pixels_at_times(const Frameless& right, const RenderJob& job, std::uint32_t pass, std::size_t tile) {
    return right.drawn(job, job.settings.seed % 6 == 0 ? 0 : pass, tile);
}

void add_variance(Catalogue& catalogue) {
    catalogue.add(
        {.id = "render/frameless/variance",
         .statement = "The variance layer of pictures whose passes draw pixels agrees with the spread of pictures.",
         .source = "ours, scenes/film/film.h",
         .kind = Kind::mean,
         .trial = {layer_is_spread,
                   frameless(),
                   {{"same-pixels", "All passes of a picture draw the same pixels.", drawn_by(same_pixels)},
                    {"at-times", "One picture in six does so.", drawn_by(same_pixels_at_times)}}}});
}

// ---- threads and shards

std::vector<float> values_of(const Subject& driver, const RenderSettings& settings, int threads) {
    std::vector<float> values;
    with_threads(threads, [&] {
        values = render({box_scene(), LightTracer({.max_edges = 3}), settings, driver}).film.image().values;
    });
    return values;
}

Verdict same_bits(const Subject& driver, const Run& run) {
    const RenderSettings settings{
        .samples_per_pass = 1, .passes = 5, .seed = run.random(0).bits(), .crop = whole_film(box_scene())};
    const LightTracer light({.max_edges = 3});
    const std::vector<float> one = values_of(driver, settings, 1), two = values_of(driver, settings, 2);
    Film merged({settings.crop.width, settings.crop.height}, render_layers({box_scene(), light, settings, driver}));
    for (const std::uint32_t part : {2u, 1u})
        merged.merge(render({box_scene(), light, part_of(settings, part, 2), driver}).film);
    const bool shards = merged.image().values == one;
    return exactly(one == two && shards, 2 * one.size(),
                   one != two ? "pixels differ between 1 and 2 threads"
                   : shards   ? "the same bits"
                              : "pixels differ between one run and two shards");
}

// Pixels by a count of all pieces so far, whoever makes them.
Subject from_one_stream() {
    return drawn_by([count = std::make_shared<std::atomic<std::uint32_t>>(0)](
                        const Frameless& right, const RenderJob& job, std::uint32_t, std::size_t tile) {
        return right.drawn(job, (*count)++, tile);
    });
}

void add_bits(Catalogue& catalogue) {
    catalogue.add(
        {.id = "render/frameless/threads",
         .statement = "1 and 2 threads, and 2 shards, give the same bits of a picture whose passes draw pixels.",
         .source = "ours, integrators/drivers/driver.h",
         .kind = Kind::exact,
         .trial = {same_bits,
                   frameless(),
                   {{"one-stream", "Who comes first draws from one stream for all.", from_one_stream()}}}});
}

}  // namespace

void add_transport_drivers(Catalogue& catalogue) {
    add_means(catalogue);
    add_variance(catalogue);
    add_bits(catalogue);
}

}  // namespace plumb::suites
