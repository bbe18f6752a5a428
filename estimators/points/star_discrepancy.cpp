#include "estimators/points/star_discrepancy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

template <class AnyPoint>
std::vector<AnyPoint> checked_and_sorted(std::vector<AnyPoint> points) {
    if (points.empty()) throw Error("star discrepancy: no points; at least one is needed");
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const double x : points[i])
            if (!(0 <= x && x <= 1))
                throw Error(fmt::format("star discrepancy: point {} has the coordinate {}; [0,1] is accepted", i, x));
    std::ranges::sort(points);
    return points;
}

}  // namespace

double star_discrepancy(const std::vector<Point<1>>& points) {
    const auto sorted = checked_and_sorted(points);
    const double n = static_cast<double>(sorted.size());
    double worst = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double x = sorted[i][0], below = static_cast<double>(i);
        worst = std::max({worst, x - below / n, (below + 1) / n - x});
    }
    return worst;
}

double star_discrepancy(const std::vector<Point<2>>& points) {
    // Boxes with x between the l-th and the next point's, and y between the k-th smallest of the l leftmost points and
    // the next, hold k points: the open one at its upper corner and the closed one at its lower corner are extreme.
    const auto sorted = checked_and_sorted(points);
    const std::size_t n = sorted.size();
    std::vector<double> y{0, 1};  // of the l leftmost points, ascending, between sentinels
    double worst = 0;
    for (std::size_t l = 0; l <= n; ++l) {
        const double left = l > 0 ? sorted[l - 1][0] : 0, right = l < n ? sorted[l][0] : 1;
        if (l > 0) y.insert(std::upper_bound(y.begin(), y.end() - 1, sorted[l - 1][1]), sorted[l - 1][1]);
        for (std::size_t k = 0; k <= l; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(n);
            worst = std::max({worst, right * y[k + 1] - share, share - left * y[k]});
        }
    }
    return worst;
}

}  // namespace plumb
