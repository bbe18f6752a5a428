#include "cli/converge_scene.h"

#include <filesystem>

#include "core/error.h"
#include "core/moments.h"
#include "core/parallel.h"
#include "integrators/integrators.h"
#include "integrators/region_estimate.h"
#include "integrators/sampler.h"
#include "scenes/mitsuba_xml.h"
#include "scenes/shipped.h"
#include "verification/convergence.h"

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
    const bool pixel = std::ranges::count(part, ',') == 1;
    return {on.substr(0, colon), parse_crop(pixel ? part + ",1,1" : part)};
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
    Sampler(sampler, 1);  // knows the name, or says so
    return {id, sampler, find_integrator(id.substr(0, plus)).make({})};
}

struct Reference {
    double mean, variance;
};

Reference reference_of(const Replicate& replicate, std::uint64_t n, std::uint64_t replicates, const Run& run) {
    std::vector<double> means(replicates);
    for_batches(replicates, [&](std::size_t i) {
        RandomStream random = run.random(i);
        means[i] = replicate(n, random).value;
    });
    const Moments all = Moments::of(means);
    return {all.mean(), all.variance() / static_cast<double>(replicates)};
}

void subtract(double variance, Series& series) {
    for (ConvergencePoint& point : series.points) {
        point.mse -= variance;
        point.mse_interval = {point.mse_interval.low - variance, point.mse_interval.high - variance};
    }
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

std::vector<Series> converge_on_scene(const std::string& on, const ConvergeOptions& options, const Run& run) {
    const Place place = parse_place(on);
    const Scene scene(load_mitsuba(scene_file(place.scene), {.lenient = true}));
    const FilmRegion region = region_of(place, scene.sensor().film());
    std::vector<Method> methods;
    for (const std::string& id : options.estimators) methods.push_back(method_of(id));
    const Replicate best = [&](std::uint64_t n, RandomStream& random) {
        return region_estimate(scene, *methods.front().estimator, "sobol", region, n, random.bits());
    };
    const Reference reference =
        reference_of(best, 4 * options.n.back(), options.replicates, run.part("reference of " + on));
    std::vector<Series> all;
    for (const Method& method : methods) {
        const Replicate replicate = [&](std::uint64_t n, RandomStream& random) {
            return region_estimate(scene, *method.estimator, method.sampler, region, n, random.bits());
        };
        const ConvergenceSetting setting{.estimator = method.id,
                                         .integrand = on,
                                         .truth = reference.mean,
                                         .n = options.n,
                                         .replicates = options.replicates};
        all.push_back(measure_convergence(replicate, setting, run.part(method.id + " on " + on)));
        subtract(reference.variance, all.back());
    }
    return all;
}

}  // namespace plumb
