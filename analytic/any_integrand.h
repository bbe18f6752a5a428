#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "analytic/integrand.h"

namespace plumb {

/// A shipped integrand of one dimension or of two, whose names are of one space.
using AnyIntegrand = std::variant<const Integrand<1>*, const Integrand<2>*>;

/// Throws Error naming the nearest ones.
AnyIntegrand find_any_integrand(std::string_view id);
/// The same; empty for a name that is none's.
std::optional<AnyIntegrand> known_integrand(std::string_view id);

}  // namespace plumb
