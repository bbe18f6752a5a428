// Pairs of mirror images.

#include <functional>

#include "estimators/points/antithetic.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

using Points = std::function<std::vector<Point<2>>(std::uint64_t, RandomStream&)>;

Verdict cancel(const Points& points, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        double sum = 0;
        for (const auto& [x, y] : points(8, random)) sum += x - 3 * y;
        return sum / 8;
    };
    return mean_is(draw, {.reference = -1, .delta = 1e-3, .epsilon = 1e-12, .cap = 256, .zero_variance = true}, run);
}

}  // namespace

void add_points_antithetic(Catalogue& catalogue) {
    catalogue.add(
        {.id = "points/antithetic/linear",
         .statement = "The mean of a linear function over antithetic pairs is its integral, for all pairs.",
         .source = "ours, estimators/points/antithetic.h",
         .kind = Kind::mean,
         .trial = {cancel,
                   antithetic_2d,
                   {{"alone", "a point of each pair stands for both", [](std::uint64_t n, RandomStream& random) {
                         auto points = antithetic_2d(n, random);
                         for (std::size_t i = 1; i < n; i += 2) points[i] = points[i - 1];
                         return points;
                     }}}}});
}

}  // namespace plumb::suites
