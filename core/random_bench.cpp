// Uniform doubles per second, against Random123's own loop over the same generator.
#include <benchmark/benchmark.h>

#include "core/random.h"

namespace plumb {
namespace {

constexpr int numbers = 4096;

void random_stream_uniform(benchmark::State& state) {
    std::uint64_t index = 0;
    for (auto _ : state) {
        RandomStream random(1, 2, ++index);
        double sum = 0;
        for (int i = 0; i < numbers; ++i) sum += random.uniform();
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * numbers);
}
BENCHMARK(random_stream_uniform);

void random123_bare_loop(benchmark::State& state) {
    std::uint64_t index = 0;
    for (auto _ : state) {
        ++index;
        double sum = 0;
        for (std::uint64_t i = 0; i < numbers / 4; ++i) {
            const auto block = r123::Philox4x64()({{i, index, 0, 0}}, {{1, 2}});
            for (const std::uint64_t bits : block) sum += static_cast<double>(bits >> 11) * 0x1p-53;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * numbers);
}
BENCHMARK(random123_bare_loop);

// What a claim's sample costs before it does anything: a stream of its own and one number.
void first_number_of_a_stream(benchmark::State& state) {
    std::uint64_t index = 0;
    for (auto _ : state) benchmark::DoNotOptimize(RandomStream(1, 2, ++index).uniform());
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(first_number_of_a_stream);

}  // namespace
}  // namespace plumb
