#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/point.h"
#include "core/spectrum.h"
#include "scenes/film/film_size.h"

namespace plumb {

/// A part of a film, in pixels, x right and y down.
struct FilmBox {
    double x = 0, y = 0, width = 0, height = 0;
};

/// A radiance of a scene that is known without rendering it (docs/scenes.md, "Known radiances").
struct KnownRadiance {
    /// point: the radiance along the ray through a film point, with a lens the mean over it. pixel: the mean over the
    /// pixel that the film point lies in. rectangle: the mean over a box. film: the mean over all of it.
    enum class Over { point, pixel, rectangle, film };

    Point<2> film;  ///< in pixels, x right and y down; a box's middle
    Over over = Over::point;
    FilmBox box;               ///< over which the mean is; of no size for a point
    std::optional<int> edges;  ///< of the longest path that counts; empty: all light
    Spectrum value;
    double error = 0;  ///< by which a channel of the value may be wrong, by rounding or quadrature
    std::string derivation;
};

/// The content of a scene's expected.json.
struct KnownScene {
    std::string question;
    FilmSize film;
    std::vector<KnownRadiance> radiances;
};

/// Reads an expected.json. Throws Error naming the file and the line or field.
KnownScene known_radiances(const std::filesystem::path& file);

}  // namespace plumb
