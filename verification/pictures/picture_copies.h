#pragma once

#include <string>

#include "verification/pictures/picture.h"

namespace plumb {

/// How one picture is made of the other, as a clause: "b is a copy of a, cut off at 1". Empty where it is not. In a
/// copy the numbers of one are an increasing function of the other's, in every pixel and channel; two sets of noisy
/// pixels never are.
std::string copies_of(const Picture& a, const Picture& b);

}  // namespace plumb
