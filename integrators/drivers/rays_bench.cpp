// Rays per second within `direct`, against Embree alone on the very same rays: what everything but tracing costs.
//   PLUMB_SCENE=scene.xml plumb_bench --benchmark_filter='rays'
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "integrators/drivers/sampler.h"
#include "integrators/integrators.h"
#include "scenes/mitsuba/mitsuba_xml.h"

namespace plumb {
namespace {

const Scene& bench_scene() {
    static const Scene scene = [] {
        const char* file = std::getenv("PLUMB_SCENE");
        return Scene(load_mitsuba(file ? file : PLUMB_SCENES "/cornell_box/scene.xml", {.lenient = true}));
    }();
    return scene;
}

// One sample of every fourth pixel in both directions: as incoherent from sample to sample as a small picture is.
void trace_picture(const PathEstimator& estimator, Sampler& sampler, PathRecord& record) {
    const FilmSize film = bench_scene().sensor().film();
    for (int y = 0; y < film.height; y += 4)
        for (int x = 0; x < film.width; x += 4) {
            const auto pixel = static_cast<std::uint32_t>(y * film.width + x);
            estimator.trace(bench_scene(), {x, y, 1, 1}, sampler.start({1, pixel, 0}), record);
            benchmark::DoNotOptimize(record.sum());
        }
}

void rays_in(benchmark::State& state, const std::string& integrator) {
    const auto estimator = make_integrator(integrator, {});
    Sampler sampler("independent", 1);
    PathRecord record;
    for (auto _ : state) trace_picture(*estimator, sampler, record);
    state.SetItemsProcessed(static_cast<std::int64_t>(record.rays.count));
}

void rays_of_embree_alone(benchmark::State& state, const std::string& integrator) {
    Sampler sampler("independent", 1);
    std::vector<TracedRay> rays;
    PathRecord record;
    record.rays.kept = &rays;
    trace_picture(*make_integrator(integrator, {}), sampler, record);
    for (auto _ : state) benchmark::DoNotOptimize(bench_scene().embree().count_hits(rays));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

BENCHMARK_CAPTURE(rays_of_embree_alone, direct, "direct");
BENCHMARK_CAPTURE(rays_in, direct, "direct");
BENCHMARK_CAPTURE(rays_of_embree_alone, path, "path");
BENCHMARK_CAPTURE(rays_in, path, "path");

}  // namespace
}  // namespace plumb
