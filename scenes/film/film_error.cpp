#include "scenes/film/film_error.h"

#include <cmath>
#include <limits>

namespace plumb {

FilmError error_of(const Film& film) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    if (film.replicates() < 2) return {unknown, unknown};
    const std::size_t channels = film.layers().front().channels.size();
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
    if (variance > 0) error.relative = square > 0 ? std::sqrt(variance / square) : unknown;
    return error;
}

}  // namespace plumb
