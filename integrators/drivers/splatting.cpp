#include "integrators/drivers/splatting.h"

namespace plumb {

namespace {

// Pixels i of [first, first + count) with |i + ½ − x| ≤ radius.
struct Span {
    int begin, end;
};
Span reached(double x, double radius, int first, int count) {
    const double low = std::ceil(x - radius - 0.5), high = std::floor(x + radius - 0.5) + 1;
    const auto within = [&](double i) { return static_cast<int>(std::clamp<double>(i, first, first + count)); };
    return {within(low), within(high)};
}

}  // namespace

void find_reached(const Filter& filter, const FilmRegion& region, const Point<2>& film,
                  std::vector<ReachedPixel>& pixels) {
    pixels.clear();
    std::visit(
        [&](const auto& f) {
            const Span columns = reached(film[0], f.radius(), region.x, region.width);
            const Span rows = reached(film[1], f.radius(), region.y, region.height);
            for (int y = rows.begin; y < rows.end; ++y) {
                const double down = f.pdf(film[1] - y - 0.5);
                for (int x = columns.begin; down > 0 && x < columns.end; ++x)
                    if (const double density = down * f.pdf(film[0] - x - 0.5); density > 0)
                        pixels.push_back({x, y, density});
            }
        },
        filter);
}

void spread(const PathRecord& record, const Filter& filter, const FilmRegion& crop, std::vector<SplatOnPixel>& splats) {
    const double paths = static_cast<double>(crop.width) * crop.height;
    thread_local std::vector<ReachedPixel> reached;
    for (const Splat& splat : record.splats) {
        if (!splat.anywhere) continue;
        find_reached(filter, crop, splat.film, reached);
        for (const auto& [x, y, density] : reached) splats.push_back({x, y, splat.value * (density / paths)});
    }
}

Spectrum region_mean(const PathRecord& record, const FilmRegion& region, const Filter& filter) {
    Spectrum mean = record.sum();
    std::vector<ReachedPixel> pixels;
    for (const Splat& splat : record.splats) {
        if (!splat.anywhere) continue;
        find_reached(filter, region, splat.film, pixels);
        double density = 0;
        for (const ReachedPixel& pixel : pixels) density += pixel.density;
        mean += splat.value * (density / (region.width * region.height));
    }
    return mean;
}

}  // namespace plumb
