// Pictures on a film: the variance layer against the spread of pictures, splats from several threads, very many
// samples.

#include "core/moments.h"
#include "core/parallel.h"
#include "integrators/drivers/render.h"
#include "integrators/drivers/sampler.h"
#include "integrators/drivers/splatting.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

// ---- the variance layer

constexpr PathLimits two_edges{.max_edges = 2};
constexpr int side = 2;

/// A floor under a square lamp, in four pixels.
const Scene& lamp_scene() {
    static const Scene scene([] {
        description::Scene lamp;
        const auto white = add_material(lamp, description::Diffuse{Spectrum::grey(0.8)});
        add_polygon(lamp, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, white);
        add_polygon(lamp, {{-0.4, -0.4, 1}, {-0.4, 0.4, 1}, {0.4, 0.4, 1}, {0.4, -0.4, 1}}, white, Spectrum::grey(1));
        lamp.sensor = camera({0, -1.2, 1.5}, {0, 0, 0}, 40, side, side);
        return lamp;
    }());
    return scene;
}

/// What a picture says of its pixels.
struct Pixel {
    double mean, variance;  ///< the latter of the mean
};
using Pixels = std::vector<Pixel>;
/// A picture from few samples, with all its randomness from the seed.
using Picture = std::function<Pixels(std::uint64_t seed)>;

RenderSettings few_samples(const std::string& sampler, std::uint64_t seed) {
    return {.sampler = sampler, .samples_per_pass = 4, .passes = 2, .seed = seed, .crop = {0, 0, side, side}};
}

Pixels render_pixels(const PathEstimator& estimator, const RenderSettings& settings) {
    const Film film = render(lamp_scene(), estimator, settings).film;
    Pixels pixels;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) pixels.push_back({film.mean(x, y, 0), film.variance_of_mean(x, y, 0)});
    return pixels;
}

/// The same pictures, with variances as if all samples were independent.
Pixels pixels_from_samples(const PathEstimator& estimator, const RenderSettings& settings) {
    Sampler sampler(settings.sampler, settings.samples_per_pass);
    PathRecord record;
    Pixels pixels;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            Moments moments;
            for (std::uint32_t i = 0; i < settings.samples_per_pass * settings.passes; ++i) {
                PrimarySamples& samples = sampler.start({settings.seed, static_cast<std::uint32_t>(y * side + x), i});
                estimator.trace(lamp_scene(), {x, y, 1, 1}, samples, record);
                moments.add(record.sum()[0]);
            }
            pixels.push_back({moments.mean(), moments.variance() / static_cast<double>(moments.count())});
        }
    return pixels;
}

/// One point of the lamp lights the whole picture, whatever the replicate.
struct OnePointOfLight final : PathEstimator {
    const PathEstimator& estimator;
    std::uint64_t seed;

    OnePointOfLight(const PathEstimator& e, std::uint64_t s) : estimator(e), seed(s) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        struct Shared final : PrimarySamples {
            PrimarySamples& own;
            IndependentSamples common;
            Shared(PrimarySamples& o, std::uint64_t s) : own(o), common({s, 0, 0}) {}
            Drawn at(Slot slot) override { return slot.use == Use::light_point ? common.at(slot) : own.at(slot); }
        } shared(samples, seed);
        estimator.trace(scene, region, shared, record);
    }
};

/// E[(a − b)²]/2 of two pictures is the variance of one: the layers' mean is compared with it, summed over pixels, in
/// units of what pilot runs show.
Verdict layer_is_spread(const Picture& picture, const Run& run) {
    double unit = 0;
    constexpr std::uint64_t pilots = 200;
    for (std::uint64_t i = 0; i < pilots; ++i)
        for (const Pixel& pixel : picture(run.part("pilots").random(i).bits())) unit += pixel.variance / pilots;
    const auto draw = [&](RandomStream& random) {
        const Pixels a = picture(random.bits()), b = picture(random.bits());
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double difference = a[i].mean - b[i].mean;
            sum += (difference * difference - a[i].variance - b[i].variance) / 2;
        }
        return sum / unit;
    };
    return mean_is(draw,
                   {.delta = run.pick(0.15, 0.03),
                    .epsilon = 1e-9,
                    .why_fewer = "pictures of a closed scene: every path brings light",
                    .cap = run.pick(std::uint64_t{1} << 17, std::uint64_t{1} << 20)},
                   run);
}

template <class E>
void add_variance(Catalogue& catalogue, const std::string& integrator, const std::string& sampler) {
    const auto pixels = [=](std::uint64_t seed) { return render_pixels(E(two_edges), few_samples(sampler, seed)); };
    Wrong<Picture> wrong{"shared", "One point of the light serves all replicates of a picture.",
                         [=](std::uint64_t seed) {
                             const E estimator(two_edges);
                             return render_pixels(OnePointOfLight(estimator, seed), few_samples(sampler, seed));
                         }};
    if (integrator == "path" && sampler != "independent")
        wrong = {"from-samples", "Squares of single samples, as if they were independent.",
                 [=](std::uint64_t seed) { return pixels_from_samples(E(two_edges), few_samples(sampler, seed)); }};
    catalogue.add({.id = "film/variance/" + integrator + "-" + sampler,
                   .statement = fmt::format("The variance layer of `{}` with {} samples agrees with the spread of "
                                            "pictures.",
                                            integrator, sampler),
                   .source = "ours, scenes/film/film.h",
                   .kind = Kind::mean,
                   .trial = {layer_is_spread, pixels, {wrong}}});
}

// ---- threads

/// A picture's numbers, made by so many threads.
using Numbers = std::function<std::vector<double>(std::uint64_t seed, int threads)>;

template <class E>
std::vector<double> rendered_by(std::uint64_t seed, int threads) {
    std::vector<double> numbers;
    with_threads(threads, [&] {
        const RenderSettings settings{
            .samples_per_pass = 1, .passes = 2, .seed = seed, .crop = whole_film(box_scene())};
        const Image image = render(box_scene(), E({.max_edges = 3}), settings).film.image();
        numbers.assign(image.values.begin(), image.values.end());
    });
    return numbers;
}

/// Splats added up as doubles, in the order in which threads come by: of one, from the first pixel on; of two, each
/// with half of the pixels, by turns.
template <class E>
std::vector<double> sums_of_doubles(std::uint64_t seed, int threads) {
    const Scene& scene = box_scene();
    const FilmRegion film = whole_film(scene);
    const E estimator({.max_edges = 3});
    IndependentSamples samples;
    PathRecord record;
    std::vector<ReachedPixel> reached;
    const int count = film.width * film.height;
    std::vector<double> sums(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const int pixel = threads == 1 ? i : i / 2 + (i % 2) * (count / 2);
        samples.start({seed, static_cast<std::uint32_t>(pixel), 0});
        estimator.trace(scene, {pixel % film.width, pixel / film.width, 1, 1}, samples, record);
        for (const Splat& splat : record.splats) {
            if (!splat.anywhere) continue;
            find_reached(scene.sensor().filter(), film, splat.film, reached);
            for (const auto& [x, y, density] : reached)
                sums[static_cast<std::size_t>(y * film.width + x)] += splat.value[0] * density;
        }
    }
    return sums;
}

Verdict same_bits(const Numbers& numbers, const Run& run) {
    const std::uint64_t seed = run.random(0).bits();
    const std::vector<double> one = numbers(seed, 1), two = numbers(seed, 2);
    return exactly(one == two, one.size(), one == two ? "the same bits" : "pixels differ between 1 and 2 threads");
}

template <class E>
void add_threads(Catalogue& catalogue, const std::string& integrator) {
    catalogue.add(
        {.id = "film/threads/" + integrator,
         .statement =
             "1 and 2 threads give the same bits of a picture onto which `" + integrator + "` splats from everywhere.",
         .source = "ours, integrators/drivers/render.cpp",
         .kind = Kind::exact,
         .trial = {same_bits, rendered_by<E>, {{"double", "Splats are added up in double.", sums_of_doubles<E>}}}});
}

// ---- 10^9 samples

constexpr std::uint64_t at_once = 1'000'000, times = 1000;

FilmPass pass_of_halves() {
    FilmPass pass({1, 1}, {{"radiance", {"Y"}}});
    const std::vector half{Spectrum::grey(0.5)};
    for (std::uint64_t i = 0; i < at_once; ++i) pass.add(0, 0, half);
    return pass;
}

/// 1,000 parts of 10^6 samples each; in the quick size one part, merged as often.
double film_of_halves(const Run& run) {
    FilmPass sum = pass_of_halves();
    const FilmPass first = sum;
    for (std::uint64_t i = 1; i < times; ++i) {
        run.end_if_stopped();
        sum.merge(run.size() == Size::quick ? first : pass_of_halves());
    }
    return sum.mean(0, 0, 0);
}

double floats_of_halves(const Run&) {
    float sum = 0;
    for (std::uint64_t i = 0; i < times * at_once && sum + 0.5f > sum; ++i) sum += 0.5f;  // further ones change nothing
    return sum / static_cast<double>(times * at_once);
}

Verdict is_half(double (*mean)(const Run&), const Run& run) {
    return within_bound({{"0.5", std::abs(mean(run) - 0.5)}}, 1e-7, "absolute");
}

}  // namespace

void add_film_pictures(Catalogue& catalogue) {
    for (const std::string sampler : {"independent", "stratified", "sobol"}) {
        add_variance<PathTracer>(catalogue, "path", sampler);
        add_variance<LightTracer>(catalogue, "light", sampler);
    }
    add_threads<LightTracer>(catalogue, "light");
    add_threads<Bdpt>(catalogue, "bdpt");
    catalogue.add({.id = "film/sums/halves",
                   .statement = "10^9 samples of 0.5 average to 0.5.",
                   .source = "ours, scenes/film/exact_sum.h",
                   .kind = Kind::bounded,
                   .trial = {is_half, film_of_halves, {{"float", "Sums in float.", floats_of_halves}}}});
}

}  // namespace plumb::suites
