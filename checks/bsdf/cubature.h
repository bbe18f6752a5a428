#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace plumb::checks {

/// A rectangle of the plane over which is integrated.
struct Rectangle {
    double x_low, x_high, y_low, y_high;

    [[nodiscard]] double area() const { return (x_high - x_low) * (y_high - y_low); }
};

/// A place of the plane where the integrand may peak.
struct Place {
    double x, y;
};

/// The integral over a rectangle, with an estimate of its error.
struct Region {
    Rectangle rectangle;
    double value, error;
    double peak;             ///< f at the node where it is largest
    bool split_x;            ///< the halves lie beside each other in x, else in y
    std::size_t halves = 0;  ///< the index of the first of the two halves, which follow each other; 0 where undivided
    std::size_t part = 0;    ///< where undivided, its position among the parts
};

/// How far a cubature goes.
struct Effort {
    double tolerance;                                          ///< of the total, absolute
    std::size_t evaluations;                                   ///< spent at most, to reach the tolerance
    double largest = std::numeric_limits<double>::infinity();  ///< value of an undivided region
};

/// The integrals over rectangles and over the regions into which they were divided.
struct Cubature {
    std::vector<Region> regions;     ///< first the rectangles given, in their order
    std::size_t rectangles = 0;      ///< how many were given
    std::vector<std::size_t> parts;  ///< the undivided regions' indices, so that few neighbours are far apart
    double total = 0;
    double error = 0;  ///< of the total: the sum over the parts

    /// The index of the undivided region that contains the place, or of the nearest where none does.
    [[nodiscard]] std::size_t region_at(Place place) const;
    /// The position of that region in `parts`.
    [[nodiscard]] std::size_t part_at(Place place) const { return regions[region_at(place)].part; }
};

/// The integrals of f(x, y) over every rectangle, halved where the error is largest until it is below the tolerance. A
/// region's error is the difference between rules of degree 7 and 5 [Genz & Malik 1983], or an eighth of what halving
/// the whole changed, if that is more. Where f at one of the places is more than twice what it is at every node, the
/// nodes have missed a peak, and the error is that value times the area. Where a region borders
/// on a larger one, f just across the border is such a place of the
/// larger.
Cubature integrate(const std::function<double(double, double)>& f, const std::vector<Rectangle>& rectangles,
                   const std::vector<Place>& places, const Effort& effort);

}  // namespace plumb::checks
