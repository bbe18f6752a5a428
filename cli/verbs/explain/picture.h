#pragma once

#include <string>
#include <vector>

#include "cli/verbs/path_options.h"
#include "core/images/image.h"
#include "integrators/references/provenance.h"

namespace plumb::cli {

/// A picture that `plumb render` wrote, and what it says of itself.
struct TellingPicture {
    std::string file;
    Image image;
    Provenance said;
};

/// The picture in this file; empty where the name is that of a scene. Throws Error for a picture that does not say how
/// it was made.
std::optional<TellingPicture> telling_picture(const std::string& scene_or_picture);

/// A pixel that stands out among its neighbours.
struct Firefly {
    int x = 0, y = 0;                      ///< on the film
    double luminance = 0, neighbours = 0;  ///< its own, and the median of the 5 x 5 pixels around it
};

/// The pixels that exceed their neighbours most, in units of these and of the picture's mean, worst first.
std::vector<Firefly> fireflies(const TellingPicture& picture, std::size_t most);

}  // namespace plumb::cli
