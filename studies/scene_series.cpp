#include "studies/scene_series.h"

#include <array>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "core/numbers.h"
#include "core/moments.h"
#include "core/parallel.h"
#include "integrators/drivers/region_estimate.h"
#include "integrators/drivers/sampler.h"
#include "integrators/integrators.h"
#include "integrators/references/reference_cache.h"
#include "integrators/references/scene_identity.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"
#include "verification/evidence/convergence.h"
#include "verification/pictures/picture.h"

namespace plumb {
namespace {

struct Place {
    std::string scene;
    std::vector<int> numbers;  // none, x,y or x,y,width,height
};

Place parse_place(const std::string& on) {
    const std::size_t colon = on.rfind(':');
    if (colon == std::string::npos) return {on, {}};
    const std::string part = on.substr(colon + 1);
    std::vector<int> numbers = parse_integers(part, 2);
    if (numbers.empty())
        numbers = parse_integers(part, 4);
    else
        numbers.insert(numbers.end(), {1, 1});
    if (numbers.empty() || numbers[2] < 1 || numbers[3] < 1)
        throw Error(fmt::format("'{}' is no part of a film; accepted: x,y or x,y,width,height in pixels", part));
    return {on.substr(0, colon), numbers};
}

FilmRegion region_of(const Place& place, FilmSize film) {
    if (place.numbers.empty()) return {0, 0, film.width, film.height};
    const auto& n = place.numbers;
    if (n[0] < 0 || n[1] < 0 || n[2] > film.width - n[0] || n[3] > film.height - n[1])
        throw Error(fmt::format("{}:{}: accepted are pixels of a film of {} x {}", place.scene, fmt::join(n, ","),
                                film.width, film.height));
    return {n[0], n[1], n[2], n[3]};
}

struct Method {
    std::string id, sampler;
    std::unique_ptr<PathEstimator> estimator;
};

Method method_of(const std::string& id) {
    const std::size_t plus = id.find('+');
    const std::string sampler = plus == std::string::npos ? "independent" : id.substr(plus + 1);
    return {id, find_sampler(sampler).id, make_integrator(id.substr(0, plus), {})};
}

/// The mean luminance of a region, with bounds of its variance.
struct Truth {
    double mean = 0;
    Interval variance{0, 0};
    std::string said = {};
};

Truth measured(const Replicate& replicate, std::uint64_t n, std::uint64_t replicates, const Run& run) {
    std::vector<double> means(replicates);
    for_batches(replicates, [&](std::size_t i) {
        RandomStream random = run.random(i);
        means[i] = replicate(n, random).value;
    });
    const Moments all = Moments::of(means);
    const double variance = all.variance() / static_cast<double>(replicates);
    return {all.mean(), {variance, variance}, {}};
}

// A picture knows the variances v of its channels but no covariances: that of the luminance Σ w x lies between Σ w² v,
// of independent channels, and (Σ w √v)², of proportional ones.
Truth read_off(const Picture& picture, const FilmRegion& region) {
    constexpr std::array weights{luminance(Spectrum::rgb(1, 0, 0)), luminance(Spectrum::rgb(0, 1, 0)),
                                 luminance(Spectrum::rgb(0, 0, 1))};
    Truth truth;
    const double n = static_cast<double>(region.width) * region.height;
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) {
            double deviation = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t k = picture.at(x, y, c);
                truth.mean += weights[c] * picture.mean[k] / n;
                truth.variance.low += weights[c] * weights[c] * picture.variance[k] / (n * n);
                deviation += weights[c] * std::sqrt(picture.variance[k]);
            }
            truth.variance.high += deviation * deviation / (n * n);
        }
    return truth;
}

// Paths of all lengths, but for `direct`.
std::optional<int> longest_path(const Method& method) {
    return Provenance{.integrator = method.id}.longest_path();
}

Reference reference_picture(const SceneMeasure& measure, const std::string& asked, const Provenance& scene,
                            std::optional<int> longest) {
    if (measure.reference == "auto") return require_reference(measure.cache, scene, longest, asked);
    Reference reference{measure.reference, read_image(measure.reference), {}};
    const std::optional<Provenance> said = provenance_of(reference.image, measure.reference);
    if (said) require_same_scene(*said, scene, measure.reference);
    if (said && longest_path_of(*said, measure.reference) != longest)
        throw Error(
            fmt::format("{}: was rendered with other lengths of paths than the estimators have", measure.reference));
    if (said) reference.provenance = *said;
    return reference;
}

Truth truth_of(const Reference& reference, const FilmRegion& region, FilmSize film) {
    const std::string file = reference.file.string();
    if (reference.image.width != film.width || reference.image.height != film.height)
        throw Error(fmt::format("{}: is {}x{} pixels, the film {}x{}", file, reference.image.width,
                                reference.image.height, film.width, film.height));
    const bool exact = !has_variance(reference.image, file);
    const Picture picture = picture_of(std::vector{reference.image}, std::vector{file}, exact);
    if (picture.channels.size() != 3 || picture.channels[0] != "R")
        throw Error(fmt::format("{}: has no channels R, G and B", file));
    Truth truth = read_off(picture, region);
    if (!std::isfinite(truth.mean)) throw Error(fmt::format("{}: has pixels there that are no finite numbers", file));
    const Provenance& by = reference.provenance;
    truth.said = by.samples_per_pixel > 0 ? fmt::format("{} ({}, {} samples a pixel, relative error {:.3g} %)", file,
                                                        by.integrator, by.samples_per_pixel, 100 * by.error.relative)
                                          : file;
    truth.said += exact ? ", whose own variance is not known and not subtracted" : ", whose own variance is subtracted";
    return truth;
}

void subtract(const Truth& truth, Series& series) {
    for (ConvergencePoint& point : series.points) subtract_variance_of_truth(point, truth.variance);
    series.slope = fit_slope(series.points, 0.95);
}

}  // namespace

bool names_scene(const std::string& on) {
    const std::string scene = parse_place(on).scene;
    return std::filesystem::exists(scene) || std::ranges::count(shipped_scene_names(), scene) > 0;
}

void check_scene_methods(const std::vector<std::string>& estimators) {
    for (const std::string& id : estimators) method_of(id);
}

SceneSeries measure_scene(const std::string& on, const SceneMeasure& measure, const Run& run) {
    const Place place = parse_place(on);
    const Scene scene(load_mitsuba(scene_file(place.scene), {.lenient = true}));
    const FilmSize film = scene.sensor().film();
    const FilmRegion region = region_of(place, film);
    std::vector<Method> methods;
    for (const std::string& id : measure.estimators) methods.push_back(method_of(id));
    Truth truth;
    if (measure.reference.empty()) {
        const Replicate best = [&](std::uint64_t n, RandomStream& random) {
            return region_estimate(scene, *methods.front().estimator, "sobol", region, n, random.bits());
        };
        truth = measured(best, 4 * measure.n.back(), measure.replicates, run.part("reference of " + on));
        truth.said = fmt::format("measured by {} with Sobol samples, {} replicates of {}; its variance is subtracted",
                                 methods.front().id, measure.replicates, 4 * measure.n.back());
    } else {
        const std::optional<int> longest = longest_path(methods.front());
        for (const Method& method : methods)
            if (longest_path(method) != longest)
                throw Error(fmt::format("{} and {} have paths of other lengths, so that no reference is both's",
                                        methods.front().id, method.id));
        truth =
            truth_of(reference_picture(measure, place.scene, identity_of(place.scene, scene.description()), longest),
                     region, film);
    }
    SceneSeries all{{}, truth.mean, truth.said};
    for (const Method& method : methods) {
        const Replicate replicate = [&](std::uint64_t n, RandomStream& random) {
            return region_estimate(scene, *method.estimator, method.sampler, region, n, random.bits());
        };
        const ConvergenceSetting setting{.estimator = method.id,
                                         .integrand = on,
                                         .truth = truth.mean,
                                         .n = measure.n,
                                         .replicates = measure.replicates};
        all.series.push_back(measure_convergence(replicate, setting, run.part(method.id + " on " + on)));
        subtract(truth, all.series.back());
    }
    return all;
}

}  // namespace plumb
