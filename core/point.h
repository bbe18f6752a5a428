#pragma once

#include <array>

namespace plumb {

/// A point of the unit cube [0,1]^D, axis by axis.
template <int D>
using Point = std::array<double, D>;

}  // namespace plumb
