#pragma once

#include "core/vec3.h"

namespace plumb {

/// The nearest float, as a double.
inline double rounded_to_float(double x) {
    float narrow = static_cast<float>(x);
    // GCC 12's SLP vectorizer drops double → float → double where it joins several into vectors, at -O2 already: the
    // double would come back as it went in. A barrier rather than -fno-tree-slp-vectorize for the target, because this
    // holds wherever the function is inlined, whatever the flags. Floats that are stored as floats are safe.
    asm("" : "+x"(narrow));
    return narrow;
}

inline Vec3 rounded_to_float(Vec3 p) {
    return {rounded_to_float(p.x), rounded_to_float(p.y), rounded_to_float(p.z)};
}

}  // namespace plumb
