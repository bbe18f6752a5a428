#pragma once

#include <cmath>

namespace plumb {

// The transfer curve of sRGB [IEC 61966-2-1] and its inverse, of values in [0, 1], in the precision of the argument.

template <class Number>
Number srgb_from_linear(Number v) {
    if (v <= Number(0.0031308)) return Number(12.92) * v;
    return Number(1.055) * std::pow(v, 1 / Number(2.4)) - Number(0.055);
}

template <class Number>
Number linear_from_srgb(Number s) {
    return s <= Number(0.04045) ? s / Number(12.92) : std::pow((s + Number(0.055)) / Number(1.055), Number(2.4));
}

}  // namespace plumb
