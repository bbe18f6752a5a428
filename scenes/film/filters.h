#pragma once

#include <variant>

#include "core/point.h"
#include "scenes/film/box_filter.h"
#include "scenes/film/gaussian_filter.h"
#include "scenes/film/tent_filter.h"

namespace plumb {

/// All filters, under the conventions of scenes/film/filter_model.h.
using FilterModels = description::Types<BoxFilter, TentFilter, GaussianFilter>;
using Filter = description::OneOf<FilterModels>;

/// The number of pixels by which film points reach beyond the outermost pixels.
inline double margin(const Filter& filter) {
    return std::visit([](const auto& f) { return std::max(0.0, f.radius() - 0.5); }, filter);
}

/// A film point, drawn by the filter, for the pixel with its corner at `pixel`.
inline Point<2> sample_film(const Filter& filter, const Point<2>& pixel, const Point<2>& u) {
    return std::visit(
        [&](const auto& f) {
            return Point<2>{pixel[0] + 0.5 + f.sample(u[0]), pixel[1] + 0.5 + f.sample(u[1])};
        },
        filter);
}

}  // namespace plumb
