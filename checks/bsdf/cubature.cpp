#include "checks/bsdf/cubature.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace plumb::checks {
namespace {

using Integrand = std::function<double(double, double)>;

constexpr std::size_t nodes = 17;

Region measured(const Integrand& integrand, const Rectangle& r) {
    static const double near = std::sqrt(9.0 / 70), far = std::sqrt(9.0 / 10), corner = std::sqrt(9.0 / 19);
    const double x = (r.x_low + r.x_high) / 2, y = (r.y_low + r.y_high) / 2;
    const double dx = (r.x_high - r.x_low) / 2, dy = (r.y_high - r.y_low) / 2;
    double peak = 0;
    const auto f = [&](double a, double b) {
        const double value = integrand(a, b);
        peak = std::max(peak, value);
        return value;
    };
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
    return {r, degree_7 * r.area(), std::abs(degree_7 - degree_5) * r.area(), peak,
            bend_x == bend_y ? dx > dy : bend_x > bend_y};
}

struct Peak {
    Place place;
    double value;
};

bool within(const Rectangle& r, const Place& p) {
    return p.x >= r.x_low && p.x <= r.x_high && p.y >= r.y_low && p.y <= r.y_high;
}

// Whether the peaks lie closer together in x than in y, in sides of the rectangle: there a cut gains most.
bool across_x(const Rectangle& r, const std::vector<Peak>& peaks) {
    const auto x = std::ranges::minmax(peaks, {}, [](const Peak& p) { return p.place.x; });
    const auto y = std::ranges::minmax(peaks, {}, [](const Peak& p) { return p.place.y; });
    const double width = r.x_high - r.x_low, height = r.y_high - r.y_low;
    const double part_x = (x.max.place.x - x.min.place.x) / width, part_y = (y.max.place.y - y.min.place.y) / height;
    return part_x == part_y ? width > height : part_x < part_y;
}

// Halves the regions of a cubature, the worst first, and deals the places out among them.
class Division {
public:
    Division(const Integrand& f, const std::vector<Rectangle>& rectangles, const std::vector<Place>& places) : f_(f) {
        cubature.rectangles = rectangles.size();
        std::vector<Peak> peaks;
        for (const Place& place : places) peaks.push_back({place, f(place.x, place.y)});
        for (const Rectangle& r : rectangles) {
            std::vector<Peak> inside;
            std::ranges::copy_if(peaks, std::back_inserter(inside), [&](const Peak& p) { return within(r, p.place); });
            add(measured(f, r), std::move(inside));
        }
        for (std::size_t i = 0; i < rectangles.size(); ++i) halve(i);
    }

    void refine(double tolerance, std::size_t evaluations) {
        while (error_ > tolerance && evaluations_ < evaluations) {
            const auto [error, index] = worst_.top();
            worst_.pop();
            if (cubature.regions[index].halves == 0 && cubature.regions[index].error == error) halve(index);
        }
    }

    // Looks across the borders of new regions into larger ones, whose nodes may all be far from this one's peak.
    void look_around() {
        const std::size_t count = cubature.regions.size();
        for (; looked_ < count; ++looked_) {
            const Region region = cubature.regions[looked_];
            if (region.halves != 0 || region.value == 0) continue;
            const Rectangle& r = region.rectangle;
            const double x = (r.x_low + r.x_high) / 2, y = (r.y_low + r.y_high) / 2;
            constexpr double across = 0.51, beside = 0.25;  // of the sides, from the middle
            for (const double side : {-across, across})
                for (const double along : {-beside, beside}) {
                    meet({x + side * (r.x_high - r.x_low), y + along * (r.y_high - r.y_low)}, r.area());
                    meet({x + along * (r.x_high - r.x_low), y + side * (r.y_high - r.y_low)}, r.area());
                }
        }
    }

    void halve(std::size_t index) {
        const Rectangle whole = cubature.regions[index].rectangle;
        Rectangle first = whole, second = whole;
        if (cubature.regions[index].split_x)
            first.x_high = second.x_low = (whole.x_low + whole.x_high) / 2;
        else
            first.y_high = second.y_low = (whole.y_low + whole.y_high) / 2;
        std::vector<Peak> peaks = std::move(peaks_[index]);
        const auto beyond = std::ranges::partition(peaks, [&](const Peak& p) { return within(first, p.place); });
        std::vector<Peak> rest(beyond.begin(), beyond.end());
        peaks.erase(beyond.begin(), beyond.end());
        error_ -= cubature.regions[index].error;
        cubature.regions[index].halves = cubature.regions.size();
        Region a = measured(f_, first), b = measured(f_, second);
        // The rules may agree by chance where few nodes meet anything; their change by halving shows it.
        const double change = std::abs(cubature.regions[index].value - a.value - b.value) / 8;
        for (Region* half : {&a, &b}) half->error = std::max(half->error, change);
        add(a, std::move(peaks));
        add(b, std::move(rest));
    }

    [[nodiscard]] double error() const { return error_; }
    [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

    Cubature cubature;

private:
    void add(const Region& region, std::vector<Peak> peaks) {
        cubature.regions.push_back(region);
        peaks_.push_back(std::move(peaks));
        evaluations_ += nodes;
        error_ += cubature.regions.back().error;
        weigh(cubature.regions.size() - 1);
    }

    // Puts what the nodes have missed into the region's error, and the region into its place in the queue.
    void weigh(std::size_t index) {
        Region& region = cubature.regions[index];
        const std::vector<Peak>& peaks = peaks_[index];
        const double highest = peaks.empty() ? 0 : std::ranges::max_element(peaks, {}, &Peak::value)->value;
        if (highest > 2 * region.peak) {
            const double error = std::max(region.error, highest * region.rectangle.area());
            error_ += error - region.error;
            region.error = error;
            region.split_x = across_x(region.rectangle, peaks);
        }
        worst_.emplace(region.error, index);
    }

    void meet(const Place& place, double area) {
        const auto inside = [&](const Region& region) { return within(region.rectangle, place); };
        const auto whole = std::ranges::subrange(
            cubature.regions.begin(), cubature.regions.begin() + static_cast<std::ptrdiff_t>(cubature.rectangles));
        if (std::ranges::none_of(whole, inside)) return;
        const std::size_t index = cubature.region_at(place);
        const Region& region = cubature.regions[index];
        if (region.rectangle.area() < 4 * area) return;
        const double value = f_(place.x, place.y);
        ++evaluations_;
        if (!(value > 2 * region.peak)) return;
        peaks_[index].push_back({place, value});
        weigh(index);
    }

    const Integrand& f_;
    std::vector<std::vector<Peak>> peaks_;
    std::priority_queue<std::pair<double, std::size_t>> worst_;
    double error_ = 0;
    std::size_t evaluations_ = 0, looked_ = 0;
};

void collect(Cubature& cubature, std::size_t index) {
    Region& region = cubature.regions[index];
    if (region.halves == 0) {
        region.part = cubature.parts.size();
        cubature.parts.push_back(index);
        cubature.total += region.value;
        cubature.error += region.error;
        return;
    }
    collect(cubature, region.halves);
    collect(cubature, region.halves + 1);
}

}  // namespace

Cubature integrate(const Integrand& f, const std::vector<Rectangle>& rectangles, const std::vector<Place>& places,
                   const Effort& effort) {
    Division division(f, rectangles, places);
    for (std::size_t evaluations = 2 * division.evaluations(); division.evaluations() < effort.evaluations;
         evaluations = std::min(2 * evaluations, effort.evaluations)) {
        division.refine(effort.tolerance, evaluations);
        if (division.evaluations() >= effort.evaluations) break;
        division.look_around();
        if (!(division.error() > effort.tolerance)) break;
    }
    std::vector<Region>& regions = division.cubature.regions;
    for (std::size_t i = 0; i < regions.size() && division.evaluations() < 2 * effort.evaluations; ++i)
        if (regions[i].halves == 0 && regions[i].value > effort.largest) division.halve(i);
    for (std::size_t i = 0; i < rectangles.size(); ++i) collect(division.cubature, i);
    return std::move(division.cubature);
}

std::size_t Cubature::region_at(Place place) const {
    std::size_t index = 0;
    const auto outside = [&](const Rectangle& r) {
        return std::max({r.x_low - place.x, place.x - r.x_high, r.y_low - place.y, place.y - r.y_high, 0.0});
    };
    for (std::size_t i = 1; i < rectangles; ++i)
        if (outside(regions[i].rectangle) < outside(regions[index].rectangle)) index = i;
    while (const std::size_t halves = regions[index].halves) {
        const Rectangle& first = regions[halves].rectangle;
        const bool beyond = regions[index].split_x ? place.x > first.x_high : place.y > first.y_high;
        index = halves + (beyond ? 1 : 0);
    }
    return index;
}

}  // namespace plumb::checks
