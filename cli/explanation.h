#pragma once

#include "cli/options.h"
#include "integrators/drivers/explanation.h"

namespace plumb::cli {

/// A sample of a scene, explained, and what was asked for.
struct ExplainedSample {
    const ExplainOptions& options;
    const Scene& scene;
    const Explanation& told;
};

/// For a person.
std::string explanation_text(const ExplainedSample& sample);
/// For a program (docs/json.md): every number to the bit.
std::string explanation_json(const ExplainedSample& sample);

}  // namespace plumb::cli
