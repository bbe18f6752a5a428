#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/point.h"
#include "core/spectrum.h"
#include "scenes/film/film_size.h"

namespace plumb {

/// A radiance of a scene that is known without rendering it (docs/scenes.md, "Known radiances").
struct KnownRadiance {
    /// point: the radiance along the ray through a film point, with a lens the mean over it. pixel: the mean over the
    /// pixel that the film point lies in.
    enum class Over { point, pixel };

    Point<2> film;  ///< in pixels, x right and y down
    Over over = Over::point;
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
