#pragma once

#include "checks/sampler/sampler.h"
#include "cli/verb.h"

namespace plumb::cli {

/// The options of `verify`; formulas of densities are read by `formula`, where it is not empty.
Action add_verify(CLI::App& verb, decltype(checks::SamplerTrial::formula) formula);
/// The part that a complaint about these options lacks.
std::string reason_of_verify(const CLI::ParseError& error);

}  // namespace plumb::cli
