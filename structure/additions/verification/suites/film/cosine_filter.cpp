// The distribution function of a cosine filter.

#include "scenes/film/cosine_filter.h"

#include <functional>

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/order.h"

namespace plumb::suites {
namespace {

const CosineFilter filter(1.5);

using Distribution = std::function<double(double x)>;

// It never falls, sample() is its inverse and pdf() its derivative.
Verdict is_distribution(const Distribution& distribution) {
    constexpr int steps = 1000;
    constexpr double h = 1e-5;
    std::vector<double> values;
    std::vector<BoundedCase> inverse, slope;
    for (int i = 1; i < steps; ++i) {
        const double u = i / static_cast<double>(steps), x = filter.sample(u);
        values.push_back(distribution(x));
        inverse.push_back({fmt::format("u = {}", u), std::abs(values.back() - u)});
        const double difference = (distribution(x + h) - distribution(x - h)) / (2 * h);
        slope.push_back({fmt::format("x = {}", x), std::abs(difference - filter.pdf(x))});
    }
    return all_of({never_falls(values), within_bound(inverse, 1e-12, "of u"), within_bound(slope, 1e-6, "of pdf")});
}

}  // namespace

void add_film_cosine_filter(Catalogue& catalogue) {
    catalogue.add(
        {.id = "film/filter-cosine/distribution",
         .statement = "sample() inverts the distribution function of the cosine filter, and pdf() is its derivative.",
         .source = "ours, scenes/film/cosine_filter.h",
         .kind = Kind::bounded,
         .trial = {
             is_distribution,
             [](double x) { return filter.invert(x); },
             {{"radius-1", "the distribution is that of radius 1", [](double x) { return CosineFilter(1).invert(x); }},
              {"falling", "it counts from above", [](double x) { return 1 - filter.invert(x); }}}}});
}

}  // namespace plumb::suites
