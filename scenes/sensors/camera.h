#pragma once

#include <array>

#include "scenes/description/models.h"
#include "scenes/film/filters.h"

// What the cameras of scene files share.
namespace plumb::description {

struct Film {
    int width = 768, height = 576;
    Filter filter = GaussianFilter();

    static constexpr std::array plugins{Plugin{"hdrfilm", "pixels of unbounded values"}};
    static Film load(Properties& properties);
};

/// The full horizontal angle, in degrees, by what the file gives along the axis that it names.
double load_fov_x(Properties& properties, const Film& film);

}  // namespace plumb::description
