// The star discrepancy: exact, against its definition and a closed form.
#include "estimators/points/star_discrepancy.h"

#include <algorithm>
#include <cmath>

#include "estimators/points/halton.h"
#include "estimators/points/strata.h"
#include "verification/claim.h"
#include "verification/suites/tally.h"

namespace plumb::suites {
namespace {

using Discrepancy = std::function<double(const std::vector<Point<2>>&)>;

/// The supremum over all boxes whose corner takes a coordinate from a point, or 1, on each axis: there it is attained,
/// by the open or by the closed box.
double by_critical_boxes(const std::vector<Point<2>>& points, bool open_boxes, bool closed_boxes, bool border) {
    const double n = static_cast<double>(points.size());
    double worst = 0;
    for (std::size_t i = 0; i < points.size() + border; ++i)
        for (std::size_t j = 0; j < points.size() + border; ++j) {
            const double x = i < points.size() ? points[i][0] : 1, y = j < points.size() ? points[j][1] : 1;
            int open = 0, closed = 0;
            for (const Point<2>& p : points) {
                open += p[0] < x && p[1] < y;
                closed += p[0] <= x && p[1] <= y;
            }
            if (open_boxes) worst = std::max(worst, x * y - open / n);
            if (closed_boxes) worst = std::max(worst, closed / n - x * y);
        }
    return worst;
}

/// All sets of n points on a grid of side × side, coincident ones included; with n and side powers of two every number
/// is exact in double, so equality is exact.
void try_all_sets(std::size_t n, std::size_t side, const Discrepancy& discrepancy, Tally& tally) {
    std::size_t sets = 1;
    for (std::size_t i = 0; i < n; ++i) sets *= side * side;
    for (std::size_t code = 0; code < sets; ++code) {
        std::vector<Point<2>> points;
        for (std::size_t i = 0, rest = code; i < n; ++i, rest /= side * side)
            points.push_back({stratum_edge(rest % side, side), stratum_edge(rest / side % side, side)});
        const double found = discrepancy(points), truth = by_critical_boxes(points, true, true, true);
        tally.expect(found == truth, [&] {
            std::string text;
            for (const auto& [x, y] : points) text += fmt::format(" ({}, {})", x, y);
            return fmt::format("{} instead of {} for the points{}", found, truth, text);
        });
    }
}

Verdict is_star_discrepancy(const Discrepancy& discrepancy) {
    Tally tally;
    try_all_sets(1, 16, discrepancy, tally);
    try_all_sets(2, 8, discrepancy, tally);
    try_all_sets(4, 4, discrepancy, tally);
    return tally.verdict("sets of 1, 2 and 4 points on small grids have the discrepancy of their worst critical box");
}

Verdict hammersley_has_its_discrepancy(std::vector<Point<2>> (*points)(std::uint64_t)) {
    Tally tally;
    for (int m = 2; m <= 10; ++m) {
        const double n = std::ldexp(1.0, m);
        const double found = 9 * n * n * star_discrepancy(points(std::uint64_t{1} << m));
        const double truth = (3 * m + 13) * n - (m % 2 == 0 ? 4 : -4);
        tally.expect(found == truth,
                     [&] { return fmt::format("9 n² D* = {} instead of {} for n = 2^{}", found, truth, m); });
    }
    return tally.verdict("Hammersley sets of 4 … 1024 points have the discrepancy of the closed form");
}

std::vector<Point<2>> centred_hammersley(std::uint64_t n) {
    auto points = hammersley_2d(n);
    for (Point<2>& point : points) point[0] += 0.5 / static_cast<double>(n);
    return points;
}

}  // namespace

void add_points_star_discrepancy(Catalogue& catalogue) {
    const auto boxes = [](bool open, bool closed, bool border) {
        return [=](const std::vector<Point<2>>& points) { return by_critical_boxes(points, open, closed, border); };
    };
    catalogue.add({
        .id = "points/star-discrepancy/brute-force",
        .statement = "The star discrepancy in O(n²) equals the worst of all critical boxes, open and closed.",
        .source = "[Bundschuh & Zhu 1993]; estimators/points/star_discrepancy.cpp",
        .trial = {is_star_discrepancy,
                  [](const std::vector<Point<2>>& points) { return star_discrepancy(points); },
                  {{"closed-boxes-only", "Boxes with too few points are not seen.", boxes(false, true, true)},
                   {"open-boxes-only", "Boxes with too many points are not seen.", boxes(true, false, true)},
                   {"border-left-out", "No box reaches 1.", boxes(true, true, false)}}},
    });
    catalogue.add({
        .id = "points/hammersley-2d/star-discrepancy",
        .statement = "n D* of Hammersley's set of n = 2^m points is m/3 + 13/9 − (−1)^m 4/(9·2^m), m = 2 … 10.",
        .source = "[Halton & Zaremba 1969]",
        .trial = {hammersley_has_its_discrepancy,
                  hammersley_2d,
                  {{"centred", "The first axis is (i + 1/2)/n.", centred_hammersley}}},
    });
}

}  // namespace plumb::suites
