// The film: sums that do not depend on order, error bars from replicates, filters as densities.

#include "scenes/film/film.h"

#include <boost/math/quadrature/gauss.hpp>

#include "estimators/densities/warps.h"
#include "estimators/points/stratified.h"
#include "scenes/film/filters.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

// ---- order

/// Values from 2^-60 to 2^30 of both signs, whose sum depends on the order in doubles.
std::vector<double> uneven_values(RandomStream& random) {
    std::vector<double> values(300);
    for (double& value : values) value = std::ldexp(random.uniform() - 0.5, static_cast<int>(random.below(90)) - 59);
    return values;
}

/// Sums in the given order, as `shards` parts that are merged from the last to the first.
using SumInParts = std::function<double(const std::vector<double>& values, std::size_t shards)>;

double film_sum(const std::vector<double>& values, std::size_t shards) {
    std::vector<FilmPass> parts(shards, FilmPass({1, 1}, {{"radiance", {"Y"}, false}}));
    for (std::size_t i = 0; i < values.size(); ++i) parts[i % shards].add(0, 0, std::vector{Spectrum::grey(values[i])});
    for (std::size_t i = shards; i-- > 1;) parts[i - 1].merge(parts[i]);
    return parts[0].mean(0, 0, 0);
}

double double_sum(const std::vector<double>& values, std::size_t) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

Verdict order_is_nothing(const SumInParts& sum, const Run& run) {
    std::uint64_t cases = 0;
    for (std::uint64_t set = 0; set < 20; ++set) {
        RandomStream random = run.random(set);
        std::vector<double> values = uneven_values(random);
        const double first = sum(values, 1);
        for (std::size_t shards = 1; shards <= 8; ++shards, ++cases) {
            shuffle<double>(values, random);
            if (const double other = sum(values, shards); other != first)
                return exactly(false, cases + 1, fmt::format("{:.17g} in one order, {:.17g} in another", first, other));
        }
    }
    return exactly(true, cases, "the same bits in every order and partition");
}

// ---- error bars

constexpr std::uint64_t strata = 8, passes = 4;

/// Film values of `passes` replicates of x averaged over one point a stratum: the variance of a replicate is
/// 1/(12 n³), that of the mean of all a fourth.
double film_variance(RandomStream& random) {
    const std::vector<FilmLayer> layers{{"radiance", {"Y"}}};
    Film film({1, 1}, layers);
    for (std::uint64_t p = 0; p < passes; ++p) {
        FilmPass pass({1, 1}, layers);
        for (const Point<1>& x : stratified_1d(strata, random)) pass.add(0, 0, std::vector{Spectrum::grey(x[0])});
        film.add(pass);
    }
    return film.variance_of_mean(0, 0, 0);
}

double variance_of_samples(RandomStream& random) {
    double sum = 0, squares = 0;
    constexpr double n = strata * passes;
    for (std::uint64_t p = 0; p < passes; ++p)
        for (const Point<1>& x : stratified_1d(strata, random)) {
            sum += x[0];
            squares += x[0] * x[0];
        }
    return (squares / n - sum * sum / (n * n)) / (n - 1);
}

Verdict variance_is_true(const Draw& draw, const Run& run) {
    constexpr double reference = 1.0 / (12.0 * strata * strata * strata * passes);
    // Replicates lie within ½ ± 1/(2n): their spread is at most (1/2n)² R/(R−1), over R.
    constexpr double largest = 0.25 / (strata * strata) / (passes - 1);
    return mean_is(draw, {.reference = reference, .delta = 0.02 * reference, .epsilon = 1e-12, .bounds = {0, largest}},
                   run);
}

// ---- filters

struct FilterCase {
    std::string name;
    Filter filter;
    double second_moment;  ///< ∫ x² h(x) dx
};

std::vector<FilterCase> filters() {
    // Cut at four: σ² (1 − 2·4 φ(4)/P(|z| ≤ 4)).
    const double phi = std::exp(-8.0) / std::sqrt(2 * pi), cut = 1 - 8 * phi / std::erf(4 / std::numbers::sqrt2);
    return {{"box", BoxFilter{}, 1.0 / 12},
            {"tent", TentFilter{1.5}, 2.25 / 6},
            {"gaussian", GaussianFilter{0.5}, 0.25 * cut}};
}

using Density = std::function<double(double)>;

double pdf_of(const Filter& filter, double x) {
    return std::visit([x](const auto& f) { return f.pdf(x); }, filter);
}
double radius_of(const Filter& filter) {
    return std::visit([](const auto& f) { return f.radius(); }, filter);
}
double sample_of(const Filter& filter, double u) {
    return std::visit([u](const auto& f) { return f.sample(u); }, filter);
}
double invert_of(const Filter& filter, double x) {
    return std::visit([x](const auto& f) { return f.invert(x); }, filter);
}

/// Its pdf is the derivative of its CDF, from 0 to 1; its sample() inverts that.
Verdict filter_is_density(const Filter& filter, const Density& pdf, const Density& sample) {
    const double r = radius_of(filter);
    std::vector<BoundedCase> cases{{"ends", std::abs(invert_of(filter, r) - invert_of(filter, -r) - 1)}};
    constexpr int cells = 32;
    for (int i = 0; i < cells; ++i) {
        const double from = r * (2.0 * i / cells - 1), to = r * (2.0 * (i + 1) / cells - 1);
        const double mass = boost::math::quadrature::gauss<double, 15>::integrate(pdf, from, to);
        cases.push_back({fmt::format("mass from {}", from),
                         std::abs(invert_of(filter, to) - invert_of(filter, from) - mass), from});
        const double u = (i + 0.5) / cells;
        cases.push_back({fmt::format("u = {}", u), std::abs(invert_of(filter, sample(u)) - u), u});
    }
    return within_bound(cases, 1e-13, "probability");
}

/// A pixel of the picture (x − ½)², with the pixel's centre at ½, as the mean of four samples of its filter.
double filtered(const Filter& filter, RandomStream& random) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const double u = random.uniform(), x = sample_film(filter, {0, 0}, {u, random.uniform()})[0] - 0.5;
        sum += x * x;
    }
    return sum / 4;
}

/// The same from uniform samples divided by their summed weights: a ratio.
double weighted(const Filter& filter, RandomStream& random) {
    double sum = 0, weights = 0;
    for (int i = 0; i < 4; ++i) {
        const double x = (2 * random.uniform() - 1) * radius_of(filter), weight = pdf_of(filter, x);
        sum += weight * x * x;
        weights += weight;
    }
    return sum / weights;
}

Verdict pixel_is(const FilterCase& filter, const Draw& draw, const Run& run) {
    const double r = radius_of(filter.filter);
    return mean_is(draw,
                   {.reference = filter.second_moment,
                    .delta = 0.01 * filter.second_moment,
                    .epsilon = 1e-14,
                    .bounds = {0, r * r}},
                   run);
}

struct Warp {
    std::function<double(double)> pdf, sample;
};

void add_filter(Catalogue& catalogue, const FilterCase& filter) {
    const std::string id = "film/filter-" + filter.name;
    const auto pdf = [f = filter.filter](double x) { return pdf_of(f, x); };
    const auto sample = [f = filter.filter](double u) { return sample_of(f, u); };
    const double off_scale = pdf(0) == 1 ? 1.1 : 1 / pdf(0);
    catalogue.add(
        {.id = id + "/density",
         .statement = "The " + filter.name + " filter is the density of its samples and integrates to 1.",
         .source = "ours, scenes/film/filters.h",
         .kind = Kind::bounded,
         .trial = {
             [f = filter.filter](const Warp& warp) { return filter_is_density(f, warp.pdf, warp.sample); },
             {pdf, sample},
             {{"not-normalised",
               "1 at the centre instead of integral 1, and a tenth more for the box.",
               {[=](double x) { return off_scale * pdf(x); }, sample}},
              {"half-pixel", "Samples lie half a pixel aside.", {pdf, [=](double u) { return sample(u) + 0.5; }}}}}});
}

void add_pixel(Catalogue& catalogue, const FilterCase& filter) {
    const Filter f = filter.filter;
    const Draw pixel = [f](RandomStream& random) { return filtered(f, random); };
    const Draw heavier = [pixel](RandomStream& random) { return 1.025 * pixel(random); };
    const Draw half_pixel = [f, r = radius_of(f)](RandomStream& random) {
        const double x = sample_of(f, random.uniform()) - 0.5;
        return std::min(x * x, r * r);
    };
    std::vector<Wrong<Draw>> wrong{{"heavier", "Weights that are 2.5 % too large.", heavier},
                                   {"half-pixel", "Samples are centred on the pixel's corner.", half_pixel}};
    if (filter.name != "box")  // whose weights are all alike
        wrong.push_back({"divided-by-weights", "Uniform samples over the sum of their weights.",
                         [f](RandomStream& random) { return weighted(f, random); }});
    catalogue.add({.id = "film/filter-" + filter.name + "/pixel",
                   .statement = "The mean of samples of the " + filter.name + " filter is the filtered picture.",
                   .source = "[Ernst, Stamminger & Greiner 2006]",
                   .kind = Kind::mean,
                   .trial = {[filter](const Draw& draw, const Run& run) { return pixel_is(filter, draw, run); }, pixel,
                             std::move(wrong)}});
}
}  // namespace

void add_film_films(Catalogue& catalogue) {
    catalogue.add({.id = "film/sums/order",
                   .statement = "A pixel has the same bits whatever the order of its samples and their partition.",
                   .source = "ours, scenes/film/exact_sum.h",
                   .kind = Kind::exact,
                   .trial = {order_is_nothing, film_sum, {{"double", "Sums in double.", double_sum}}}});
    catalogue.add({.id = "film/variance/replicates",
                   .statement = "The film's variance of the mean is unbiased for stratified samples.",
                   .source = "ours, scenes/film/film.h",
                   .kind = Kind::mean,
                   .trial = {variance_is_true,
                             film_variance,
                             {{"from-samples", "Taken from squares of single samples.", variance_of_samples},
                              {"five-percent", "5 % too small.",
                               [](RandomStream& random) { return 0.95 * film_variance(random); }}}}});
    for (const FilterCase& filter : filters()) {
        add_filter(catalogue, filter);
        add_pixel(catalogue, filter);
    }
}

}  // namespace plumb::suites
