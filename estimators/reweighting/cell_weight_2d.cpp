#include "estimators/reweighting/cell_weight_2d.h"

#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analytic/disk_rectangle.h"
#include "core/error.h"
#include "core/random.h"

namespace plumb {
namespace {

struct Rule {
    std::vector<double> nodes, weights;  ///< on (0,1)
};

/// Gauss and Legendre's rule after the substitution t = s²(3 − 2s), which turns the half-integer powers that touching
/// balls leave at both ends into analytic functions.
Rule smoothed_gauss_legendre(int order) {
    Rule rule;
    for (const double zero : boost::math::legendre_p_zeros<double>(order))  // those ≥ 0
        for (const double x : {zero, -zero}) {
            const double slope = boost::math::legendre_p_prime(order, x), s = (1 + x) / 2;
            rule.nodes.push_back(s * s * (3 - 2 * s));
            rule.weights.push_back(6 * s * (1 - s) / ((1 - x * x) * slope * slope));
            if (zero == 0) break;
        }
    return rule;
}

/// ∫ f over the pieces between sorted breaks.
template <class F>
double integrate(const F& f, std::vector<double>& breaks, const Rule& rule) {
    std::ranges::sort(breaks);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double width = breaks[i + 1] - breaks[i];
        if (width <= 0) continue;
        for (std::size_t k = 0; k < rule.nodes.size(); ++k)
            sum += width * rule.weights[k] * f(breaks[i] + width * rule.nodes[k]);
    }
    return sum;
}

void add_inside(std::vector<double>& breaks, double t, double end) {
    if (0 < t && t < end) breaks.push_back(t);
}

/// ∫_0^1 (1 − P(B(x + s v, s|v|)))^{N−1} s ds along the ray from x to x + v, on the boundary.
double along_ray(std::uint64_t n, const Point<2>& x, const Point<2>& v, const BallMeasure& ball, const Rule& rule) {
    const double length = std::hypot(v[0], v[1]);
    if (length == 0) return 0;
    std::vector<double> breaks{0, 1};
    for (int axis = 0; axis < 2; ++axis)
        for (const double c : ball.jumps[axis])  // the ball touches a line
            add_inside(breaks, std::abs(c - x[axis]) / (length + (c < x[axis] ? -v[axis] : v[axis])), 1);
    for (const double cx : ball.jumps[0])  // the ball reaches a crossing
        for (const double cy : ball.jumps[1]) {
            const double dx = cx - x[0], dy = cy - x[1];
            add_inside(breaks, (dx * dx + dy * dy) / (2 * (v[0] * dx + v[1] * dy)), 1);
        }
    const double cell_size = 1.5 / std::sqrt(static_cast<double>(n));
    for (double radius = cell_size; radius < length; radius *= 2) breaks.push_back(radius / length);
    const auto integrand = [&](double s) {
        const double p = ball.probability({x[0] + s * v[0], x[1] + s * v[1]}, s * length);
        return std::pow(std::max(0.0, 1 - p), static_cast<double>(n - 1)) * s;
    };
    return integrate(integrand, breaks, rule);
}

/// The integral over the triangle between x and one side of the square: y = x + s (b(t) − x), dy = distance · s ds dt,
/// t along the side.
double over_triangle(std::uint64_t n, const Point<2>& x, int axis, double side, const BallMeasure& ball,
                     const Rule& rule) {
    const double distance = std::abs(side - x[axis]), foot = x[1 - axis];
    if (distance == 0) return 0;
    std::vector<double> breaks{0, 1};
    add_inside(breaks, foot, 1);
    for (double step = std::max(distance, 0x1p-30); step < 1; step *= 4) {  // rays turn fast near the foot
        add_inside(breaks, foot - step, 1);
        add_inside(breaks, foot + step, 1);
    }
    const auto ray = [&](double t) {
        Point<2> v;
        v[axis] = side - x[axis];
        v[1 - axis] = t - foot;
        return along_ray(n, x, v, ball, rule);
    };
    return distance * integrate(ray, breaks, rule);
}

}  // namespace

BallMeasure uniform_ball() {
    return {[](const Point<2>& centre, double radius) { return disk_rectangle_area(centre, radius); }};
}

double cell_weight_2d(std::uint64_t n, const Point<2>& x, const BallMeasure& ball, int order) {
    if (n == 0) throw Error("the expected cell of one of 0 samples does not exist; accepted are 1 and more");
    if (!(0 <= x[0] && x[0] <= 1 && 0 <= x[1] && x[1] <= 1))
        throw Error(fmt::format("g at ({}, {}): accepted are points of the unit square", x[0], x[1]));
    const Rule rule = smoothed_gauss_legendre(order);
    double sum = 0;
    for (const int axis : {0, 1})
        for (const double side : {0.0, 1.0}) sum += over_triangle(n, x, axis, side, ball, rule);
    return static_cast<double>(n) * sum;
}

CellWeightTable2D::CellWeightTable2D(std::uint64_t n, const BallMeasure& ball, int nodes) {
    const auto& [xs, ys] = ball.jumps;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
        for (std::size_t j = 0; j + 1 < ys.size(); ++j)
            patches_.emplace_back(Rectangle{{xs[i], ys[j]}, {xs[i + 1], ys[j + 1]}}, nodes,
                                  [&](const Point<2>& x) { return cell_weight_2d(n, x, ball); });
    measure_error(n, ball);
}

CellWeightTable2D::CellWeightTable2D(std::uint64_t n, int nodes)
    : fold_(std::min(0.5, 7 / std::sqrt(static_cast<double>(n)))) {
    const BallMeasure ball = uniform_ball();
    std::map<Point<2>, double> known;  // g(x,y) = g(y,x)
    const auto g = [&](const Point<2>& x) {
        const auto mirrored = known.find({x[1], x[0]});
        return known[x] = mirrored == known.end() ? cell_weight_2d(n, x, ball) : mirrored->second;
    };
    patches_.emplace_back(Rectangle{{0, 0}, {fold_, fold_}}, nodes, g);
    measure_error(n, ball);
}

void CellWeightTable2D::measure_error(std::uint64_t n, const BallMeasure& ball) {
    RandomStream random(n, stream_id("cell weight table"));
    for (int i = 0; i < 64; ++i) {
        const Point<2> x{fold_ * random.uniform(), fold_ * random.uniform()};
        error_ = std::max(error_, 4 * std::abs((*this)(x)-cell_weight_2d(n, x, ball, 20)));
    }
}

double CellWeightTable2D::operator()(Point<2> x) const {
    if (fold_ < 1)
        for (double& u : x) u = std::min({u, 1 - u, fold_});
    const auto holds_x = [&](const ChebyshevPatch& patch) {
        return x[0] <= patch.box().high[0] && x[1] <= patch.box().high[1];
    };
    const auto patch = std::ranges::find_if(patches_, holds_x);  // they are sorted: the first is the one
    if (patch == patches_.end())
        throw Error(fmt::format("g at ({}, {}): accepted are points of the unit square", x[0], x[1]));
    return (*patch)(x);
}

double CellWeightTable2D::smallest() const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const ChebyshevPatch& patch : patches_) smallest = std::min(smallest, std::ranges::min(patch.values()));
    return smallest;
}

double CellWeightTable2D::largest() const {
    double largest = 0;
    for (const ChebyshevPatch& patch : patches_) largest = std::max(largest, std::ranges::max(patch.values()));
    return largest;
}

}  // namespace plumb
