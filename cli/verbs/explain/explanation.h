#pragma once

#include <cstdint>
#include <string>

#include "integrators/drivers/explanation.h"
#include "integrators/method.h"
#include "scenes/shipped/loaded_scene.h"

namespace plumb::cli {

/// A sample of a render, explained, and what was asked for.
struct ExplainedSample {
    const LoadedScene& scene;
    const RenderMethod& method;
    const RenderSettings& settings;
    int x = 0, y = 0;  ///< of the pixel
    std::uint32_t index = 0;
    const Explanation& told;

    [[nodiscard]] std::uint64_t samples_per_pixel() const {
        return std::uint64_t{settings.passes} * settings.samples_per_pass;
    }
};

/// The explanation as a person reads it.
std::string explanation_text(const ExplainedSample& sample);
/// The explanation as a program reads it (docs/json.md): every number to the bit.
std::string explanation_json(const ExplainedSample& sample);

}  // namespace plumb::cli
