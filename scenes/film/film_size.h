#pragma once

namespace plumb {

struct FilmSize {
    int width, height;  ///< pixels
};

}  // namespace plumb
