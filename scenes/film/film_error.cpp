#include "scenes/film/film_error.h"

#include <cmath>
#include <limits>

namespace plumb {

FilmError error_of(const Film& film) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const std::size_t channels = film.layers().front().channels.size();
    if (film.replicates() < 2) return {unknown, unknown, std::vector<double>(channels, unknown)};
    double variance = 0, square = 0, count = 0;
    for (int y = 0; y < film.size().height; ++y)
        for (int x = 0; x < film.size().width; ++x)
            for (std::size_t c = 0; c < channels; ++c) {
                const double m = film.mean(x, y, c), v = film.variance_of_mean(x, y, c);
                variance += v;
                square += m * m - v;
                ++count;
            }
    FilmError error{std::sqrt(variance / count), 0};
    for (std::size_t c = 0; c < channels; ++c) error.of_means.push_back(std::sqrt(film.variance_of_picture_mean(c)));
    if (variance > 0) error.relative = square > 0 ? std::sqrt(variance / square) : unknown;
    return error;
}

// Let a and b estimate the same variance of a replicate, with p and q degrees of freedom. Their mean, weighted by p and
// q, has the variance of a − b times pq/(p + q)², whatever the law: both are means of as many alike terms. Pixels are
// summed as if they were independent; a pixel's channels, which are not, are one.
double error_of_variance(const Film& one, const Film& other) {
    if (one.replicates() < 2 || other.replicates() < 2) return std::numeric_limits<double>::infinity();
    const auto p = static_cast<double>(one.replicates() - 1), q = static_cast<double>(other.replicates() - 1);
    const std::size_t channels = one.layers().front().channels.size();
    const auto of_replicate = [&](const Film& film, int x, int y) {
        double sum = 0;
        for (std::size_t c = 0; c < channels; ++c) sum += film.variance_of_mean(x, y, c);
        return sum * static_cast<double>(film.replicates());
    };
    double together = 0, squared_differences = 0;
    for (int y = 0; y < one.size().height; ++y)
        for (int x = 0; x < one.size().width; ++x) {
            const double a = of_replicate(one, x, y), b = of_replicate(other, x, y);
            together += (p * a + q * b) / (p + q);
            squared_differences += (a - b) * (a - b);
        }
    if (together == 0) return 0;
    return std::sqrt(p * q * squared_differences) / ((p + q) * together);
}

}  // namespace plumb
