#include "analytic/radiosity.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <span>

#include "analytic/quadrature_rules.h"
#include "core/error.h"

namespace plumb {

namespace {

using std::numbers::pi;

/// Lagrange's polynomials of the nodes, at x.
std::vector<double> lagrange(const std::vector<double>& nodes, double x) {
    std::vector<double> basis;
    for (const double own : nodes) {
        double product = 1;
        for (const double other : nodes)
            if (other != own) product *= (x - other) / (own - other);
        basis.push_back(product);
    }
    return basis;
}

/// ∫ p_a(s) p_b(t) k(x, y(s, t)) dA(y) over a plate, of every pair of Lagrange's polynomials.
class Moments {
public:
    Moments(const std::vector<double>& nodes, Vec3 x, Vec3 normal_x, const RadiosityPlate& plate,
            std::span<double> moments)
        : nodes_(nodes),
          rule_(gauss_legendre<double>(static_cast<int>(nodes.size()) + 4)),
          x_(x),
          normal_x_(normal_x),
          plate_(plate),
          normal_(plate.normal()),
          area_(length(cross(plate.edge_1, plate.edge_2))),
          moments_(moments) {}

    struct Range {
        double from, to;
        [[nodiscard]] double length() const { return to - from; }
        [[nodiscard]] double middle() const { return (from + to) / 2; }
    };
    void add(const Range& s, const Range& t) {
        const double size = std::hypot(s.length() * length(plate_.edge_1), t.length() * length(plate_.edge_2));
        if (size <= 1.5 * distance_to(s, t)) return add_cell(s, t);
        for (const Range& half_s : {Range{s.from, s.middle()}, Range{s.middle(), s.to}})
            for (const Range& half_t : {Range{t.from, t.middle()}, Range{t.middle(), t.to}}) add(half_s, half_t);
    }

private:
    [[nodiscard]] double distance_to(const Range& s, const Range& t) const {
        const Vec3 from_corner = x_ - plate_.corner;
        const auto nearest = [&](Vec3 edge, const Range& range) {
            return std::clamp(dot(from_corner, edge) / length_squared(edge), range.from, range.to);
        };
        return length(x_ - plate_.point(nearest(plate_.edge_1, s), nearest(plate_.edge_2, t)));
    }

    struct AxisPoint {
        double at, weight;
        std::vector<double> basis;
    };
    [[nodiscard]] std::vector<AxisPoint> axis(const Range& range) const {
        std::vector<AxisPoint> points;
        for (std::size_t i = 0; i < rule_.node.size(); ++i) {
            const double at = range.from + range.length() * rule_.node[i];
            points.push_back({at, range.length() * rule_.weight[i], lagrange(nodes_, at)});
        }
        return points;
    }

    void add_cell(const Range& s_range, const Range& t_range) {
        const std::vector<AxisPoint> along_t = axis(t_range);
        const std::size_t n = nodes_.size();
        std::vector<double> row(n);
        for (const AxisPoint& s : axis(s_range)) {
            std::ranges::fill(row, 0.0);
            for (const AxisPoint& t : along_t) {
                const double value = kernel(plate_.point(s.at, t.at)) * t.weight;
                for (std::size_t b = 0; b < n; ++b) row[b] += value * t.basis[b];
            }
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b) moments_[a * n + b] += area_ * s.weight * s.basis[a] * row[b];
        }
    }

    [[nodiscard]] double kernel(Vec3 y) const {
        const Vec3 way = y - x_;
        const double d2 = length_squared(way);
        return std::max(0.0, dot(normal_x_, way)) * std::max(0.0, -dot(normal_, way)) / (pi * d2 * d2);
    }

    const std::vector<double>& nodes_;
    Rule<double> rule_;
    Vec3 x_, normal_x_;
    const RadiosityPlate& plate_;
    Vec3 normal_;
    double area_;
    std::span<double> moments_;
};

}  // namespace

Radiosity::Radiosity(std::vector<RadiosityPlate> plates, int n, int reflections) : plates_(std::move(plates)) {
    if (reflections < 1 && reflections != -1)
        throw Error(fmt::format("{} reflections; accepted are 1 and more, and -1 for all", reflections));
    const Rule<double> rule = gauss_legendre<double>(n);
    nodes_ = rule.node;
    weights_ = rule.weight;
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < plates_.size(); ++i) {
        if (!(plates_[i].albedo >= 0 && plates_[i].albedo < 1))
            throw Error(fmt::format("plate {}: albedo {}; accepted are 0 to below 1", i, plates_[i].albedo));
        if (!std::isfinite(plates_[i].emission))
            throw Error(fmt::format("plate {}: emission {}; accepted are finite numbers", i, plates_[i].emission));
        for (const double s : nodes_)
            for (const double t : nodes_) rows.push_back(gathering(i, s, t));
    }
    const std::size_t per_plate = nodes_.size() * nodes_.size();
    for (std::size_t i = 0; i < rows.size(); ++i) radiance_.push_back(plates_[i / per_plate].emission);
    constexpr int most = 10'000;
    bool changes = true;
    for (int done = 1; changes && done != reflections; ++done) {
        if (done == most) throw Error(fmt::format("radiosity: {} reflections do not end it; lower the albedos", most));
        std::vector<double> next;
        for (std::size_t i = 0; i < rows.size(); ++i) next.push_back(leaving(i / per_plate, rows[i]));
        const auto settled = [](double a, double b) { return std::abs(a - b) <= 1e-14 * std::abs(a); };
        changes = !std::ranges::equal(next, radiance_, settled);
        radiance_ = std::move(next);
    }
}

/// What the radiance at each node adds to the irradiance at a point of a plate, over π.
std::vector<double> Radiosity::gathering(std::size_t plate, double s, double t) const {
    const std::size_t per_plate = nodes_.size() * nodes_.size();
    std::vector<double> weights(plates_.size() * per_plate);
    for (std::size_t j = 0; j < plates_.size(); ++j) {
        if (j == plate) continue;
        const std::span part = std::span(weights).subspan(j * per_plate, per_plate);
        Moments(nodes_, plates_[plate].point(s, t), plates_[plate].normal(), plates_[j], part).add({0, 1}, {0, 1});
    }
    return weights;
}

double Radiosity::leaving(std::size_t plate, const std::vector<double>& weights) const {
    return plates_[plate].emission +
           plates_[plate].albedo * std::inner_product(weights.begin(), weights.end(), radiance_.begin(), 0.0);
}

double Radiosity::radiance(std::size_t plate, double s, double t) const {
    return leaving(plate, gathering(plate, s, t));
}

double Radiosity::integral(std::size_t plate) const {
    const std::size_t n = nodes_.size();
    double sum = 0;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b) sum += weights_[a] * weights_[b] * radiance_[(plate * n + a) * n + b];
    return sum * length(cross(plates_[plate].edge_1, plates_[plate].edge_2));
}

}  // namespace plumb
