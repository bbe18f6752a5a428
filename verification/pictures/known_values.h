#pragma once

#include <span>
#include <string>
#include <vector>

#include "verification/pictures/image_comparison.h"

namespace plumb {

/// A value that a picture ought to have: its mean over a rectangle, a square of a pixel's size where none is said.
struct KnownValue {
    std::string name = {}, source = {};  ///< what it is called, and how one comes by it
    double x = 0, y = 0;                 ///< the rectangle's centre, in pixels: pixel (i, j) has i + 1/2, j + 1/2
    std::vector<double> value;           ///< of each of the picture's channels
    double error = 0;                    ///< by which a value may be wrong
    double width = 1, height = 1;        ///< of the rectangle
};

/// The risks and the tolerance with which a picture is held to known values.
struct CheckSettings {
    double alpha = 1e-4;  ///< of refuting a picture whose values are all right within delta
    double beta = 0.01;   ///< of `holds` when what is said to hold is off by delta or more
    double delta = 0.01;  ///< by which a value may be off, relative to what is known (docs/compare.md)
};

/// The test of one known value in one channel.
struct CheckedValue {
    std::size_t known = 0, channel = 0;
    TileState state = TileState::no_pixels;
    MeanDifference found = {};  ///< a is the picture's value, b the known one
};

/// The test of all known values of a channel together.
struct CheckedTogether {
    std::size_t channel = 0, values = 0;  ///< how many there are
    TileState state = TileState::no_pixels;
    MeanDifference found = {};  ///< of means over the values, each divided by what its deviation is relative to
};

/// The test of a picture against all known values.
struct ValuesCheck {
    Verdict verdict = {};
    std::vector<CheckedValue> values = {};       ///< known by known, channel by channel
    std::vector<CheckedTogether> together = {};  ///< channel by channel; none for a single known value
};

/// The verdict on whether the picture has the known values within delta. The mean over a rectangle is that of the
/// pixels that it overlaps, weighted by their areas: over a square between pixels that is exact where the picture is
/// linear about it. At an edge the rectangle is moved inside. Refuted values are found by Holm's step-down over all of
/// them, at half of alpha; the mean of their relative deviations, which many noisy values tell together, is tested at
/// the other half.
ValuesCheck check(const Picture& picture, std::span<const KnownValue> known, const CheckSettings& settings = {});

}  // namespace plumb
