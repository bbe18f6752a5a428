#pragma once

#include <array>

#include "scenes/description/models.h"
#include "scenes/film/filters.h"

// The cameras of scene files share what follows.
namespace plumb::description {

/// A film as the file has it: its size and its reconstruction filter.
struct Film {
    int width = 768, height = 576;
    Filter filter = GaussianFilter();

    static constexpr std::array plugins{Plugin{"hdrfilm", "pixels of unbounded values"}};
    static Film load(Properties& properties);
};

/// The full horizontal angle of view, in degrees, from what the file gives along the axis that it names.
double load_fov_x(Properties& properties, const Film& film);

}  // namespace plumb::description
