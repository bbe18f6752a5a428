#pragma once

#include "cli/verbs/path_options.h"
#include "integrators/drivers/explanation.h"

namespace plumb::cli {

/// One path of a render.
struct ExplainOptions : PathOptions {
    int x = 0, y = 0;  ///< of the pixel
    std::uint32_t sample = 0;
    std::uint32_t replicates = 0;  ///< passes of the render; 0: as `render --spp` cuts them
    std::string json;
};

/// A sample of a scene, explained, and what was asked for.
struct ExplainedSample {
    const ExplainOptions& options;
    const Scene& scene;
    const Explanation& told;
};

/// The explanation as a person reads it.
std::string explanation_text(const ExplainedSample& sample);
/// The explanation as a program reads it (docs/json.md): every number to the bit.
std::string explanation_json(const ExplainedSample& sample);

}  // namespace plumb::cli
