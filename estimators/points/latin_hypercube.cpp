#include "estimators/points/latin_hypercube.h"

#include "estimators/points/point_count.h"
#include "estimators/points/strata.h"

namespace plumb {

std::vector<Point<2>> latin_hypercube_2d(std::uint64_t n, RandomStream& random) {
    const std::vector<std::uint32_t> row = random_permutation(point_count(n, "latin-hypercube"), random);
    std::vector<Point<2>> points(n);
    for (std::uint64_t i = 0; i < n; ++i) {
        const double x = in_stratum(i, n, random.uniform());
        points[i] = {x, in_stratum(row[i], n, random.uniform())};
    }
    return points;
}

}  // namespace plumb
