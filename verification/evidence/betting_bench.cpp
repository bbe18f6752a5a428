// What the mean test costs a sample, draws excluded.
#include <benchmark/benchmark.h>

#include "core/random.h"
#include "verification/evidence/betting.h"

namespace plumb {
namespace {

void mean_test(benchmark::State& state, const Interval& bounds) {
    RandomStream random(1);
    std::vector<double> values(1 << 18);
    for (double& x : values) x = random.uniform() - 0.5;
    const double delta = 1e-6;  // far below what the samples can decide: every block is played
    for (auto _ : state) {
        MeanTest test({{0, 0}, {-delta, delta}, delta, bounds, 1e-6, 0.01, 0});
        for (std::size_t used = 0; used < values.size();) {
            const auto block = std::span(values).subspan(used, std::min(test.block_size(), values.size() - used));
            benchmark::DoNotOptimize(test.add(block));
            used += block.size();
        }
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * values.size()));
}

BENCHMARK_CAPTURE(mean_test, bounded, Interval{-0.5, 0.5});
BENCHMARK_CAPTURE(mean_test, unbounded, Interval{});

}  // namespace
}  // namespace plumb
