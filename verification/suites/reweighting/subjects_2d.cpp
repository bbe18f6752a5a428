#include "verification/suites/reweighting/subjects_2d.h"

#include "estimators/points/stratified.h"
#include "estimators/reweighting/reweighting_2d.h"
#include "estimators/voronoi/voronoi_2d.h"

namespace plumb::suites {

double exp_sum(const Point<2>& x) {
    return std::exp(x[0] + x[1]);
}

Draw weighted(const Function<2>& f, std::uint64_t n, const Weigh& weigh) {
    return [=](RandomStream& random) {
        const Samples x = independent_points<2>(n, random);
        return weighted_sum(f, x, weigh(x)).value;
    };
}

namespace {

/// Cells of the samples among those copies shifted by (i,j), |i|, |j| ≤ 1, that `present` keeps, inside [−1,2]².
template <class Present>
std::vector<double> cells_among_copies(std::span<const Point<2>> samples, Present present) {
    Samples all;
    for (const int i : {0, -1, 1})
        for (const int j : {0, -1, 1})
            if (present(i, j))
                for (const Point<2>& x : samples) all.push_back({(x[0] + 1 + i) / 3, (x[1] + 1 + j) / 3});
    std::vector<double> areas = voronoi_areas(all);
    areas.resize(samples.size());
    for (double& area : areas) area *= 9;
    return areas;
}

}  // namespace

std::vector<double> copies_missing_on_the_left(std::span<const Point<2>> samples) {
    return cells_among_copies(samples, [](int i, int) { return i >= 0; });
}

std::vector<double> diagonal_copies_missing(std::span<const Point<2>> samples) {
    return cells_among_copies(samples, [](int i, int j) { return i == 0 || j == 0; });
}

std::vector<double> not_clipped(std::span<const Point<2>> samples) {
    return cells_among_copies(samples, [](int i, int j) { return i == 0 && j == 0; });
}

std::vector<double> coincident_counted_fully(std::span<const Point<2>> samples) {
    std::map<Point<2>, int> count;
    for (const Point<2>& x : samples) ++count[x];
    std::vector<double> areas = voronoi_areas(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) areas[i] *= count[samples[i]];
    return areas;
}

}  // namespace plumb::suites
