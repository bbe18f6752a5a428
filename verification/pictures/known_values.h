#pragma once

#include <span>
#include <string>
#include <vector>

#include "verification/pictures/image_comparison.h"

namespace plumb {

/// A value that a picture ought to have: its mean over a square of a pixel's size.
struct KnownValue {
    std::string name = {}, source = {};  ///< what it is called, and how one comes by it
    double x = 0, y = 0;                 ///< the square's centre, in pixels: pixel (i, j) has i + 1/2, j + 1/2
    std::vector<double> value;           ///< of each of the picture's channels
    double error = 0;                    ///< by which a value may be wrong
};

/// The risks and the tolerance with which a picture is held to known values.
struct CheckSettings {
    double alpha = 1e-4;  ///< of refuting a picture whose values are all right within delta
    double beta = 0.01;   ///< of `holds` when a value is off by delta or more
    double delta = 0.01;  ///< by which a value may be off, relative to what is known (docs/compare.md)
};

/// The test of one known value in one channel.
struct CheckedValue {
    std::size_t known = 0, channel = 0;
    TileState state = TileState::no_pixels;
    MeanDifference found = {};  ///< a is the picture's value, b the known one
};

/// The test of a picture against all known values.
struct ValuesCheck {
    Verdict verdict = {};
    std::vector<CheckedValue> values = {};  ///< known by known, channel by channel
};

/// The verdict on whether the picture has the known values within delta. The mean over a square between pixels is that
/// of the pixels that it overlaps, weighted by their areas: exact where the picture is linear about the square. At an
/// edge the square is moved inside. Refuted values are found by Holm's step-down over all of them.
ValuesCheck check(const Picture& picture, std::span<const KnownValue> known, const CheckSettings& settings = {});

}  // namespace plumb
