#include "cli/verbs/sampler/formula_density.h"

#include <cmath>
#include <memory>

#include "analytic/expression.h"
#include "core/box.h"
#include "core/error.h"

namespace plumb::cli {
namespace {

constexpr std::size_t steps_1d = 1 << 18, steps_2d = 1 << 10;  // of an axis
constexpr std::size_t cells_1d = 64, cells_2d = 8;

template <int D>
Box<D> box_of(const std::vector<double>& domain) {
    Box<D> box;
    for (int axis = 0; axis < D && !domain.empty(); ++axis) {
        box.low[axis] = domain[2 * static_cast<std::size_t>(axis)];
        box.high[axis] = domain[2 * static_cast<std::size_t>(axis) + 1];
    }
    return box;
}

template <int D>
double value_at(const Expression& f, const Point<D>& p) {
    const double value = f(p);
    if (!(value >= 0 && std::isfinite(value)))
        throw Error(fmt::format("--density: {} is {} at {:.6g}; accepted: finite values >= 0", f.text(), value,
                                fmt::join(p, ", ")));
    return value;
}

std::string normalised(double integral) {
    return fmt::format(" (normalised by Plumb: its integral is {:.6g})", integral);
}

// The integral from the left end up to each step, by midpoints.
std::vector<double> sums_of(const Expression& f, const Box<1>& box, std::size_t steps) {
    std::vector<double> sums{0};
    const double width = box.volume() / static_cast<double>(steps);
    for (std::size_t i = 0; i < steps; ++i)
        sums.push_back(sums.back() + width * value_at<1>(f, {box.low[0] + (static_cast<double>(i) + 0.5) * width}));
    return sums;
}

// Half as many steps must say the same, or the density has a place that midpoints do not see.
void require_settled(const std::string& text, double fine, double coarse) {
    if (!(fine > 0)) throw Error(fmt::format("--density: {} is 0 throughout the domain", text));
    if (std::abs(fine - coarse) > 1e-4 * fine)
        throw Error(
            fmt::format("--density: the integral of {} is {:.6g} or {:.6g} by two sums: too narrow or unbounded "
                        "somewhere; give a table of cells with their probabilities",
                        text, fine, coarse));
}

checks::CellDensity in_one_dimension(const std::string& text, const std::vector<double>& domain) {
    const auto f = std::make_shared<const Expression>(text);
    const Box<1> box = box_of<1>(domain);
    const auto sums = std::make_shared<const std::vector<double>>(sums_of(*f, box, steps_1d));
    const double integral = sums->back();
    require_settled(text, integral, sums_of(*f, box, steps_1d / 2).back());

    checks::CellDensity density{.name = text, .dimension = 1, .cells = {}};
    density.remark = normalised(integral);
    density.pdf = [=](const Point<2>& p) { return (*f)(Point<1>{p[0]}) / integral; };
    density.cumulative = [=](double x) {
        const double at = std::clamp(box.to_unit(x, 0), 0.0, 1.0) * steps_1d;
        const std::size_t step = std::min(static_cast<std::size_t>(at), steps_1d - 1);
        return std::lerp((*sums)[step], (*sums)[step + 1], at - static_cast<double>(step)) / integral;
    };
    // Cells of about equal probability: their ends are steps.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < cells_1d; ++i) {
        const double until = integral * static_cast<double>(i + 1) / cells_1d;
        std::size_t end = i + 1 == cells_1d ? steps_1d : begin + 1;
        while (end < steps_1d && (*sums)[end] < until) ++end;
        const auto place = [&](std::size_t step) {
            return std::lerp(box.low[0], box.high[0], static_cast<double>(step) / steps_1d);
        };
        density.cells.push_back({{place(begin), place(end)}, {}, ((*sums)[end] - (*sums)[begin]) / integral});
        if ((begin = end) == steps_1d) break;
    }
    return density;
}

double sum_over(const Expression& f, const Interval& x, const Interval& y, std::size_t steps) {
    double sum = 0;
    const auto n = static_cast<double>(steps);
    for (std::size_t i = 0; i < steps; ++i)
        for (std::size_t j = 0; j < steps; ++j)
            sum += value_at<2>(f, {std::lerp(x.low, x.high, (static_cast<double>(i) + 0.5) / n),
                                   std::lerp(y.low, y.high, (static_cast<double>(j) + 0.5) / n)});
    return sum / (n * n) * x.width() * y.width();
}

checks::CellDensity in_two_dimensions(const std::string& text, const std::vector<double>& domain) {
    const auto f = std::make_shared<const Expression>(text);
    const Box<2> box = box_of<2>(domain);
    checks::CellDensity density{.name = text, .dimension = 2, .cells = {}};
    double integral = 0, coarse = 0;
    const auto part = [&](int axis, std::size_t i) {
        const auto end = [&](std::size_t k) {
            return std::lerp(box.low[axis], box.high[axis], static_cast<double>(k) / cells_2d);
        };
        return Interval{end(i), end(i + 1)};
    };
    for (std::size_t i = 0; i < cells_2d; ++i)
        for (std::size_t j = 0; j < cells_2d; ++j) {
            density.cells.push_back({part(0, i), part(1, j), 0});
            checks::CellDensity::Cell& cell = density.cells.back();
            cell.probability = sum_over(*f, cell.x, cell.y, steps_2d / cells_2d);
            integral += cell.probability;
            coarse += sum_over(*f, cell.x, cell.y, steps_2d / cells_2d / 2);
        }
    require_settled(text, integral, coarse);
    for (checks::CellDensity::Cell& cell : density.cells) cell.probability /= integral;
    density.remark = normalised(integral);
    density.pdf = [=](const Point<2>& p) { return (*f)(p) / integral; };
    return density;
}

}  // namespace

checks::CellDensity formula_density(const std::string& text, const std::vector<double>& domain) {
    const bool two = domain.size() == 4 || Expression(text).uses_y();
    if (two && domain.size() == 2)
        throw Error(fmt::format("--domain has 2 numbers; {} is a function of x and y", text));
    return two ? in_two_dimensions(text, domain) : in_one_dimension(text, domain);
}

}  // namespace plumb::cli
