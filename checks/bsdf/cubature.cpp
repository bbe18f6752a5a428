#include "checks/bsdf/cubature.h"

#include <algorithm>
#include <cmath>

namespace plumb::checks {
namespace {

struct Region {
    Rectangle rectangle;
    std::size_t owner;
    double value, error;
    bool split_x;
};

constexpr std::size_t points = 17;

Region measured(const std::function<double(double, double)>& f, const Rectangle& r, std::size_t owner) {
    static const double near = std::sqrt(9.0 / 70), far = std::sqrt(9.0 / 10), corner = std::sqrt(9.0 / 19);
    const double x = (r.x_low + r.x_high) / 2, y = (r.y_low + r.y_high) / 2;
    const double dx = (r.x_high - r.x_low) / 2, dy = (r.y_high - r.y_low) / 2;
    const auto along_x = [&](double t) { return f(x - t * dx, y) + f(x + t * dx, y); };
    const auto along_y = [&](double t) { return f(x, y - t * dy) + f(x, y + t * dy); };
    const auto corners = [&](double t) {
        return f(x - t * dx, y - t * dy) + f(x - t * dx, y + t * dy) + f(x + t * dx, y - t * dy) +
               f(x + t * dx, y + t * dy);
    };
    const double centre = f(x, y), x_near = along_x(near), y_near = along_y(near), x_far = along_x(far),
                 y_far = along_y(far), outer = corners(far), inner = corners(corner);
    const double degree_7 =
        (-3816 * centre + 2940 * (x_near + y_near) + 1020 * (x_far + y_far) + 200 * outer + 6859.0 / 4 * inner) / 19683;
    const double degree_5 =
        (-971 * centre + 245.0 * 1.5 * (x_near + y_near) + 65.0 / 2 * (x_far + y_far) + 25 * outer) / 729;
    const double bend_x = std::abs(x_near - 2 * centre - (x_far - 2 * centre) / 7);
    const double bend_y = std::abs(y_near - 2 * centre - (y_far - 2 * centre) / 7);
    const double area = 4 * dx * dy;
    return {r, owner, degree_7 * area, std::abs(degree_7 - degree_5) * area,
            bend_x == bend_y ? dx > dy : bend_x > bend_y};
}

std::pair<Rectangle, Rectangle> halves(const Region& region) {
    Rectangle first = region.rectangle, second = first;
    if (region.split_x)
        first.x_high = second.x_low = (first.x_low + first.x_high) / 2;
    else
        first.y_high = second.y_low = (first.y_low + first.y_high) / 2;
    return {first, second};
}

bool less_wrong(const Region& a, const Region& b) {
    return a.error < b.error;
}

}  // namespace

Cubature integrate(const std::function<double(double, double)>& f, const std::vector<Rectangle>& rectangles,
                   double tolerance, std::size_t evaluations) {
    std::vector<Region> heap;
    double error = 0;
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
        heap.push_back(measured(f, rectangles[i], i));
        error += heap.back().error;
    }
    std::ranges::make_heap(heap, less_wrong);
    for (std::size_t used = points * heap.size(); error > tolerance && used < evaluations; used += 2 * points) {
        std::ranges::pop_heap(heap, less_wrong);
        const Region worst = heap.back();
        heap.pop_back();
        error -= worst.error;
        const auto [first, second] = halves(worst);
        for (const Rectangle& half : {first, second}) {
            heap.push_back(measured(f, half, worst.owner));
            error += heap.back().error;
            std::ranges::push_heap(heap, less_wrong);
        }
    }
    Cubature result;
    result.values.resize(rectangles.size());
    for (const Region& region : heap) {
        result.values[region.owner] += region.value;
        result.total += region.value;
        result.error += region.error;
    }
    return result;
}

}  // namespace plumb::checks
