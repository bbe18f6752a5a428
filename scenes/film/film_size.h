#pragma once

namespace plumb {

/// The size of a film.
struct FilmSize {
    int width, height;  ///< pixels
};

}  // namespace plumb
