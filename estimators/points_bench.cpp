// Points per second of the sets that are used most, and the 1D weights of a million samples.
#include <benchmark/benchmark.h>

#include "core/random.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/sobol.h"
#include "estimators/reweighting/cells_1d.h"

namespace plumb {
namespace {

void sobol_points(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(sobol_2d(static_cast<std::uint64_t>(state.range(0))));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(sobol_points)->Arg(1024)->Arg(1 << 20);

void owen_sobol_points(benchmark::State& state) {
    RandomStream random(1);
    for (auto _ : state) benchmark::DoNotOptimize(owen_sobol_2d(static_cast<std::uint64_t>(state.range(0)), random));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(owen_sobol_points)->Arg(1024)->Arg(1 << 20);

void multi_jittered_points(benchmark::State& state) {
    RandomStream random(1);
    for (auto _ : state)
        benchmark::DoNotOptimize(correlated_multi_jittered_2d(static_cast<std::uint64_t>(state.range(0)), random));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(multi_jittered_points)->Arg(1024)->Arg(1 << 20);

void torus_weights(benchmark::State& state) {
    RandomStream random(1);
    std::vector<double> samples(static_cast<std::size_t>(state.range(0)));
    for (double& x : samples) x = random.uniform();
    for (auto _ : state) benchmark::DoNotOptimize(torus_weights_1d(samples));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(torus_weights)->Arg(1024)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
