// The areas of Voronoi cells, and of disks in a rectangle.
#include <numbers>

#include "analytic/disk_rectangle.h"
#include "analytic/disk_rectangle_exact.h"
#include "analytic/disk_rectangle_hard_cases.h"
#include "estimators/points/stratified.h"
#include "estimators/voronoi/voronoi_2d.h"
#include "estimators/voronoi/voronoi_brute_force.h"
#include "estimators/voronoi/voronoi_hard_sets.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/reweighting/subjects_2d.h"

namespace plumb::suites {
namespace {

std::vector<HardSet> corpus(const Run& run, std::size_t largest) {
    std::vector<HardSet> sets;
    for (HardSet& set : voronoi_hard_sets())
        if (set.samples.size() <= largest) sets.push_back(std::move(set));
    for (std::uint64_t i = 0; i < 50; ++i) {
        RandomStream random = run.random(i);
        sets.push_back({fmt::format("{} random samples", i + 1), independent_points<2>(i + 1, random)});
    }
    return sets;
}

Verdict weights_sum_to_1(const Weigh& weigh, const Run& run) {
    std::vector<BoundedCase> cases;
    for (const HardSet& set : corpus(run, 200000)) {
        const std::vector<double> weights = weigh(set.samples);
        double sum = 0, smallest = 0;
        for (const double w : weights) sum += w, smallest = std::min(smallest, w);
        cases.push_back({set.name, std::abs(sum - 1) + (smallest < 0 ? 1 : 0)});
    }
    return within_bound(cases, 1e-12, "absolute");
}

Verdict areas_agree(const Weigh& weigh, const Weigh& reference, bool only_separated, const Run& run) {
    std::vector<BoundedCase> cases;
    for (const HardSet& set : corpus(run, 300)) {
        if (only_separated && !set.separated) continue;
        const std::vector<double> found = weigh(set.samples), truth = reference(set.samples);
        double worst = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) worst = std::max(worst, std::abs(found[i] - truth[i]));
        cases.push_back({set.name, worst});
    }
    return within_bound(cases, 1e-12, "absolute");
}

void add_areas(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-voronoi/sum-to-1",
        .statement = "Areas of clipped Voronoi cells are non-negative and sum to 1 within 1e-12, on random and on "
                     "degenerate samples.",
        .source = "ours, estimators/voronoi/voronoi_2d.h",
        .kind = Kind::bounded,
        .trial = {weights_sum_to_1,
                  voronoi_areas,
                  {{"not-clipped", "boundary cells reach out of the square", not_clipped},
                   {"coincident-counted-fully", "each of several coincident samples gets the whole cell",
                    coincident_counted_fully}}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus/sum-to-1",
        .statement = "Areas of Voronoi cells on the torus are non-negative and sum to 1 within 1e-12, on random and on "
                     "degenerate samples.",
        .source = "ours, estimators/voronoi/voronoi_2d.h",
        .kind = Kind::bounded,
        .trial = {weights_sum_to_1,
                  voronoi_areas_periodic,
                  {{"copies-missing-on-the-left", "periodic copies are added on three sides only",
                    copies_missing_on_the_left}}},
    });
    catalogue.add({
        .id = "reweighting/2d-voronoi/areas",
        .statement = "Clipped Voronoi areas equal the square cut by every bisector, within 1e-12.",
        .source = "definition of the cell, estimators/voronoi/voronoi_brute_force.h",
        .kind = Kind::bounded,
        .trial = {[](const Weigh& weigh, const Run& run) {
                      return areas_agree(weigh, brute_force_voronoi_areas, false, run);
                  },
                  voronoi_areas,
                  {{"torus", "cells on the torus", voronoi_areas_periodic}}},
    });
    catalogue.add({
        .id = "reweighting/2d-torus/areas",
        .statement =
            "Voronoi areas on the torus equal the square around a sample cut by every bisector with every copy, "
            "within 1e-12.",
        .source = "definition of the cell, estimators/voronoi/voronoi_brute_force.h",
        .kind = Kind::bounded,
        .trial = {[=](const Weigh& weigh, const Run& run) {
                      return areas_agree(weigh, brute_force_voronoi_areas_periodic, true, run);
                  },
                  voronoi_areas_periodic,
                  {{"diagonal-copies-missing", "periodic copies only to the left, right, below and above",
                    diagonal_copies_missing},
                   {"clipped", "clipped cells called periodic", voronoi_areas}}},
    });
}

/// The same area with arc sines, whose sum cancels against π/2 where the disk is thin in the rectangle.
double quarter_by_arc_sines(double w, double h, double r) {
    w = std::min(w, r);
    h = std::min(h, r);
    if (w * w + h * h <= r * r) return w * h;
    return (w * std::sqrt(r * r - w * w) + h * std::sqrt(r * r - h * h) +
            r * r * (std::asin(w / r) + std::asin(h / r) - std::numbers::pi / 2)) /
           2;
}
double disk_area_by_arc_sines(const Point<2>& c, double r, const Rectangle& box) {
    double sum = 0;
    for (const double w : {c[0] - box.low[0], box.high[0] - c[0]})
        for (const double h : {c[1] - box.low[1], box.high[1] - c[1]}) sum += quarter_by_arc_sines(w, h, r);
    return sum;
}

Verdict disk_area_is_stable(double (*area)(const Point<2>&, double, const Rectangle&)) {
    std::vector<BoundedCase> cases;
    for (const DiskCase& c : disk_rectangle_hard_cases()) {
        const double truth = disk_rectangle_area_by_chords(c.centre, c.radius, c.rectangle);
        cases.push_back({c.name, ulp_error(area(c.centre, c.radius, c.rectangle), truth), c.radius});
    }
    return stable(cases, 8, "area of a disk in a rectangle", "radius");
}

void add_disk(Catalogue& catalogue) {
    catalogue.add({
        .id = "reweighting/2d-disk/stable",
        .statement = "The area of a disk in a rectangle that holds its centre is right within 8 ulp.",
        .source = "ours, analytic/disk_rectangle.cpp",
        .kind = Kind::bounded,
        .trial = {disk_area_is_stable,
                  disk_rectangle_area,
                  {{"arc-sines", "the textbook formula with arc sines", disk_area_by_arc_sines}}},
    });
}

}  // namespace

void add_reweighting_areas_2d(Catalogue& catalogue) {
    add_areas(catalogue);
    add_disk(catalogue);
}

}  // namespace plumb::suites
