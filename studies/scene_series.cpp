#include "studies/scene_series.h"

#include <array>
#include <cmath>

#include "core/error.h"
#include "core/moments.h"
#include "core/parallel.h"
#include "integrators/drivers/region_estimate.h"
#include "integrators/references/reference_cache.h"
#include "integrators/references/scene_identity.h"
#include "verification/evidence/convergence.h"
#include "verification/pictures/picture.h"

namespace plumb {
namespace {

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

// Of the longest paths; empty: of any length.
std::optional<int> longest_path(const SceneMethod& method) {
    return Provenance{.integrator = method.render.integrator, .limits = method.render.limits}.longest_path();
}

std::optional<int> longest_path(const std::vector<SceneMethod>& methods) {
    const std::optional<int> longest = longest_path(methods.front());
    for (const SceneMethod& method : methods)
        if (longest_path(method) != longest)
            throw Error(fmt::format("{} and {} have paths of other lengths, so that no reference is both's",
                                    methods.front().id, method.id));
    return longest;
}

Reference reference_picture(const SceneMeasure& measure, const LoadedScene& scene) {
    const std::optional<int> longest = longest_path(measure.methods);
    if (measure.reference == "auto") return require_reference(measure.cache, scene, longest);
    Reference reference{measure.reference, read_image(measure.reference), {}};
    const std::optional<Provenance> said = provenance_of(reference.image, measure.reference);
    if (said) require_same_scene(*said, identity_of(scene), measure.reference);
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

Replicate replicate_of(const ScenePart& part, const SceneMethod& method) {
    return [scene = part.scene, region = part.region, sampler = method.render.sampler,
            estimator = std::shared_ptr(estimator_of(method.render))](std::uint64_t n, RandomStream& random) {
        return region_estimate(scene->scene, *estimator, sampler, region, n, random.bits());
    };
}

void subtract(const Truth& truth, Series& series) {
    for (ConvergencePoint& point : series.points) subtract_variance_of_truth(point, truth.variance);
    series.slope = fit_slope(series.points, 0.95);
}

}  // namespace

SceneSeries measure_scene(const ScenePart& part, const SceneMeasure& measure, const Run& run) {
    std::vector<Replicate> replicates;
    for (const SceneMethod& method : measure.methods) replicates.push_back(replicate_of(part, method));
    const SceneMethod& first = measure.methods.front();
    Truth truth;
    if (measure.reference.empty()) {
        const std::uint64_t n = 4 * measure.n.back();
        SceneMethod best = first;
        best.render.sampler = "sobol";
        truth = measured(replicate_of(part, best), n, measure.replicates, run.part("reference of " + part.id));
        truth.said = fmt::format("measured by {} with Sobol samples, {} replicates of {}; its variance is subtracted",
                                 first.id, measure.replicates, n);
    } else {
        truth = truth_of(reference_picture(measure, *part.scene), part.region, part.scene->scene.sensor().film());
    }
    SceneSeries all{{}, truth.mean, truth.said};
    for (std::size_t i = 0; i < replicates.size(); ++i) {
        const std::string& id = measure.methods[i].id;
        const ConvergenceSetting setting{.estimator = id,
                                         .integrand = part.id,
                                         .truth = truth.mean,
                                         .n = measure.n,
                                         .replicates = measure.replicates};
        all.series.push_back(measure_convergence(replicates[i], setting, run.part(id + " on " + part.id)));
        subtract(truth, all.series.back());
    }
    return all;
}

}  // namespace plumb
