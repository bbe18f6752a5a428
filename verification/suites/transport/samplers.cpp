// What stratified and Owen-scrambled samples gain `path`, at equal samples; the report plots the same at equal work and
// seconds.

#include "integrators/drivers/region_estimate.h"
#include "verification/claim.h"
#include "verification/evidence/convergence.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

/// Whose numbers, under which name.
struct Numbers {
    std::string name, sampler;
};

/// Pixels on a wall, the floor's edge, the block's, and in its penumbra.
constexpr std::array<FilmRegion, 4> pixels{{{5, 9}, {9, 24}, {20, 21}, {26, 27}}};

Estimate mean_of_pixels(const std::string& sampler, std::uint64_t n, std::uint64_t seed) {
    const PathTracer path({.max_edges = 3});
    Estimate mean{0, HUGE_VAL, 0};
    for (const FilmRegion& pixel : pixels) {
        const Estimate estimate = region_estimate(box_scene(), path, sampler, pixel, n, seed);
        mean.value += estimate.value / pixels.size();
        mean.evaluations += estimate.evaluations;
    }
    return mean;
}

/// Its squared error is a hundredth of those that are measured against it.
double truth() {
    static const double mean = mean_of_pixels("sobol", std::uint64_t{1} << 13, stream_id("truth")).value;
    return mean;
}

Series errors(const Numbers& numbers, const Run& run) {
    const ConvergenceSetting setting{
        "path, " + numbers.name, "pixels of a box", truth(), {4, 16, 64}, run.pick<std::uint64_t>(1200, 12'000)};
    return measure_convergence(
        [&](std::uint64_t n, RandomStream& random) { return mean_of_pixels(numbers.sampler, n, random.bits()); },
        setting, run.part(numbers.name));
}

Verdict gain(const std::vector<Numbers>& samplers, const Run& run) {
    const Series independent = errors({"independent", "independent"}, run);
    std::vector<Verdict> parts;
    for (const Numbers& numbers : samplers) {
        const Series series = errors(numbers, run);
        const Run part = run.part(numbers.name, 1 / static_cast<double>(samplers.size()));
        parts.push_back(mse_ratio_is(series, independent, {0, 0.5}, part));
        parts.back().series = {series};
    }
    Verdict verdict = all_of(std::move(parts));
    verdict.series.push_back(independent);
    return verdict;
}

}  // namespace

void add_transport_samplers(Catalogue& catalogue) {
    catalogue.add(
        {.id = "render/path/samplers",
         .statement =
             "In pixels of a box, 64 stratified or Owen-scrambled paths of up to 3 edges have at most half the "
             "MSE of independent ones.",
         .source = "[Mitchell 1996; Owen 1997]; the factor is measured",
         .kind = Kind::ratio,
         .trial = {gain,
                   {{"stratified", "stratified"}, {"sobol", "sobol"}},
                   {{"stratified-independent",
                     "Independent numbers by the name of stratified ones.",
                     {{"stratified", "independent"}}},
                    {"sobol-independent",
                     "Independent numbers by the name of Owen-scrambled ones.",
                     {{"sobol", "independent"}}}}}});
}

}  // namespace plumb::suites
