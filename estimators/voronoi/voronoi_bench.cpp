// Voronoi areas against Qhull's Delaunay triangulation of the same points, in one run:
//   cmake --build --preset release --target plumb_bench && build/release/estimators/plumb_bench
#include <benchmark/benchmark.h>
#include <libqhull_r/qhull_ra.h>

#include <string>

#include "core/random.h"
#include "estimators/voronoi/voronoi_2d.h"

namespace plumb {
namespace {

std::vector<Point<2>> uniform_points(std::int64_t n) {
    RandomStream random(1, stream_id("voronoi_bench"));
    std::vector<Point<2>> points(static_cast<std::size_t>(n));
    for (Point<2>& x : points) x = {random.uniform(), random.uniform()};
    return points;
}

void bounded(benchmark::State& state) {
    const auto points = uniform_points(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(voronoi_areas(points));
    state.SetComplexityN(state.range(0));
}

void periodic(benchmark::State& state) {
    const auto points = uniform_points(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(voronoi_areas_periodic(points));
    state.SetComplexityN(state.range(0));
}

/// Qhull's Delaunay triangulation, without areas: a lower bound of what Voronoi areas by Qhull cost.
void qhull_delaunay(benchmark::State& state) {
    auto points = uniform_points(state.range(0));
    std::string options = "qhull d Qbb Qc Qz Q12";
    for (auto _ : state) {
        qhT qh;
        qh_zero(&qh, stderr);
        if (qh_new_qhull(&qh, 2, static_cast<int>(points.size()), points.data()->data(), False, options.data(), nullptr,
                         stderr))
            state.SkipWithError("Qhull failed");
        benchmark::DoNotOptimize(qh.num_facets);
        qh_freeqhull(&qh, qh_ALL);
    }
    state.SetComplexityN(state.range(0));
}

const auto sizes = [](auto* run) {
    run->RangeMultiplier(10)
        ->Range(1000, 1000000)
        ->Arg(1024)
        ->Unit(benchmark::kMillisecond)
        ->Complexity(benchmark::oNLogN);
};
BENCHMARK(bounded)->Apply(sizes);
BENCHMARK(periodic)->Apply(sizes);
BENCHMARK(qhull_delaunay)->Apply(sizes);

}  // namespace
}  // namespace plumb
