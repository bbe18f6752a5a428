// Values beyond what a pixel's own sum holds: kept, in any order.

#include "scenes/film/film.h"
#include "verification/suites/suites.h"
#include "verification/suites/tally.h"

namespace plumb::suites {
namespace {

__extension__ using Integer = __int128;

/// Multiples of 2^-20, some of them up to 2^90, and the double nearest to their mean.
struct Case {
    std::vector<double> values;
    double mean = 0;
};

Case uneven_case(RandomStream& random) {
    Case one;
    Integer sum = 0;
    for (int i = 0; i < 300; ++i) {
        const auto digits = static_cast<std::int64_t>(random.bits()) >> (12 + random.below(40));
        const auto shift = static_cast<int>(random.below(10) == 0 ? random.below(60) : 0);
        one.values.push_back(std::ldexp(static_cast<double>(digits), shift - 20));
        sum += static_cast<Integer>(digits) << shift;
    }
    one.mean = std::ldexp(static_cast<double>(sum), -20) / static_cast<double>(one.values.size());
    return one;
}

/// A pixel's mean of values that come in this order, to so many shards, merged from the last to the first.
using PixelMean = double (*)(const std::vector<double>& values, std::size_t shards);

double film_mean(const std::vector<double>& values, std::size_t shards) {
    std::vector<FilmPass> parts(shards, FilmPass({1, 1}, {{"radiance", {"Y"}, false}}));
    for (std::size_t i = 0; i < values.size(); ++i) parts[i % shards].add(0, 0, std::vector{Spectrum::grey(values[i])});
    for (std::size_t i = shards; i-- > 1;) parts[i - 1].merge(parts[i]);
    return parts[0].mean(0, 0, 0);
}

double mean_without_large(const std::vector<double>& values, std::size_t shards) {
    std::vector<double> kept = values;
    for (double& value : kept)
        if (!ExactSum::accepts(value)) value = 0;
    return film_mean(kept, shards);
}

double mean_in_doubles(const std::vector<double>& values, std::size_t) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double mean_of_clamped(const std::vector<double>& values, std::size_t shards) {
    std::vector<double> clamped = values;
    for (double& value : clamped) value = std::clamp(value, -0x1p30, 0x1p30);
    return film_mean(clamped, shards);
}

Verdict is_exact(PixelMean mean, const Run& run) {
    Tally tally;
    for (std::uint64_t set = 0; set < 20; ++set) {
        RandomStream random = run.random(set);
        Case one = uneven_case(random);
        for (std::size_t shards = 1; shards <= 8; ++shards) {
            shuffle<double>(one.values, random);
            const double found = mean(one.values, shards);
            tally.expect(found == one.mean, [&] { return fmt::format("{:.17g}, not {:.17g}", found, one.mean); });
        }
    }
    return tally.verdict("means of values up to 2^90 are exact in every order and partition");
}

}  // namespace

void add_film_large(Catalogue& catalogue) {
    catalogue.add({.id = "film/sums/large",
                   .statement = "A pixel's mean is that of its samples, rounded once, where some are of 2^31 and more.",
                   .source = "ours, scenes/film/wide_sum.h",
                   .kind = Kind::exact,
                   .trial = {is_exact,
                             film_mean,
                             {{"dropped", "Values of 2^31 and more add nothing.", mean_without_large},
                              {"clamped", "They count as 2^30.", mean_of_clamped},
                              {"double", "Sums in double.", mean_in_doubles}}}});
}

}  // namespace plumb::suites
