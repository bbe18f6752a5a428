#include "estimators/cell_weight_2d.h"

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
double along_ray(std::uint64_t n, const Point<2>& x, const Point<2>& v, const BallProbability& ball, const Rule& rule) {
    const double length = std::hypot(v[0], v[1]);
    if (length == 0) return 0;
    std::vector<double> breaks{0, 1};
    for (int axis = 0; axis < 2; ++axis) {  // the ball touches a side
        add_inside(breaks, x[axis] / (length - v[axis]), 1);
        add_inside(breaks, (1 - x[axis]) / (length + v[axis]), 1);
    }
    for (const double cx : {0.0, 1.0})  // the ball reaches a corner
        for (const double cy : {0.0, 1.0}) {
            const double dx = cx - x[0], dy = cy - x[1];
            add_inside(breaks, (dx * dx + dy * dy) / (2 * (v[0] * dx + v[1] * dy)), 1);
        }
    const double cell_size = 1.5 / std::sqrt(static_cast<double>(n));
    for (double radius = cell_size; radius < length; radius *= 2) breaks.push_back(radius / length);
    const auto integrand = [&](double s) {
        const double p = ball({x[0] + s * v[0], x[1] + s * v[1]}, s * length);
        return std::pow(std::max(0.0, 1 - p), static_cast<double>(n - 1)) * s;
    };
    return integrate(integrand, breaks, rule);
}

/// Over the triangle between x and one side of the square: y = x + s (b(t) − x), dy = distance · s ds dt, t along the
/// side.
double over_triangle(std::uint64_t n, const Point<2>& x, int axis, double side, const BallProbability& ball,
                     const Rule& rule) {
    const double distance = std::abs(side - x[axis]), foot = x[1 - axis];
    if (distance == 0) return 0;
    std::vector<double> breaks{0, 1};
    add_inside(breaks, foot, 1);
    for (double step = distance; step < 1; step *= 4) {  // rays turn fast near the foot of a short perpendicular
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

/// Chebyshev points of the second kind on [0, width], both ends included.
std::vector<double> chebyshev(int count, double width) {
    std::vector<double> nodes;
    for (int i = 0; i < count; ++i) nodes.push_back(width * (1 - std::cos(std::numbers::pi * i / (count - 1))) / 2);
    return nodes;
}

/// The weights with which the values at Chebyshev points make up the interpolant at x [Berrut and Trefethen 2004,
/// eq. 5.4].
std::vector<double> barycentric(const std::vector<double>& nodes, double x) {
    std::vector<double> weights(nodes.size(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (x == nodes[i]) {
            std::ranges::fill(weights, 0.0);
            weights[i] = 1;
            return weights;
        }
        weights[i] = (i % 2 ? -1 : 1) * (i == 0 || i + 1 == nodes.size() ? 0.5 : 1) / (x - nodes[i]);
        sum += weights[i];
    }
    for (double& w : weights) w /= sum;
    return weights;
}

}  // namespace

double uniform_ball(const Point<2>& centre, double radius) {
    return disk_rectangle_area(centre, radius);
}

double cell_weight_2d(std::uint64_t n, const Point<2>& x, const BallProbability& ball, int order) {
    if (n == 0) throw Error("the expected cell of one of 0 samples does not exist; accepted are 1 and more");
    const Rule rule = smoothed_gauss_legendre(order);
    double sum = 0;
    for (const int axis : {0, 1})
        for (const double side : {0.0, 1.0}) sum += over_triangle(n, x, axis, side, ball, rule);
    return static_cast<double>(n) * sum;
}

CellWeightTable2D::CellWeightTable2D(std::uint64_t n, const BallProbability& ball, int nodes)
    : symmetric_(false), width_(1), nodes_(chebyshev(nodes, width_)) {
    fill(n, ball);
}

CellWeightTable2D::CellWeightTable2D(std::uint64_t n, int nodes)
    : symmetric_(true), width_(std::min(0.5, 7 / std::sqrt(static_cast<double>(n)))), nodes_(chebyshev(nodes, width_)) {
    fill(n, uniform_ball);
}

void CellWeightTable2D::fill(std::uint64_t n, const BallProbability& ball) {
    const std::size_t count = nodes_.size();
    values_.resize(count * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            values_[i * count + j] =
                symmetric_ && j < i ? values_[j * count + i] : cell_weight_2d(n, {nodes_[i], nodes_[j]}, ball);
    RandomStream random(n, stream_id("cell weight table"));
    for (int i = 0; i < 64; ++i) {
        const Point<2> x{width_ * random.uniform(), width_ * random.uniform()};
        error_ = std::max(error_, 4 * std::abs((*this)(x)-cell_weight_2d(n, x, ball, 20)));
    }
}

Point<2> CellWeightTable2D::folded(Point<2> x) const {
    if (symmetric_)
        for (double& u : x) u = std::min({u, 1 - u, width_});
    return x;
}

double CellWeightTable2D::operator()(Point<2> x) const {
    x = folded(x);
    const std::vector<double> row = barycentric(nodes_, x[0]), column = barycentric(nodes_, x[1]);
    double sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = 0; j < column.size(); ++j) sum += row[i] * column[j] * values_[i * column.size() + j];
    return sum;
}

double CellWeightTable2D::smallest() const {
    return *std::ranges::min_element(values_);
}
double CellWeightTable2D::largest() const {
    return *std::ranges::max_element(values_);
}

}  // namespace plumb
