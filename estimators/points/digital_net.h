#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// Points in base 2 before and after scrambling: each coordinate a fraction of 64 binary digits, x = digits · 2^-64.
template <int D>
using BinaryPoint = std::array<std::uint64_t, D>;

/// Coordinates rounded down to the 53 digits of a double, so that they stay below 1.
template <int D>
std::vector<Point<D>> to_points(const std::vector<BinaryPoint<D>>& digits) {
    std::vector<Point<D>> points(digits.size());
    for (std::size_t i = 0; i < digits.size(); ++i)
        for (int axis = 0; axis < D; ++axis) points[i][axis] = static_cast<double>(digits[i][axis] >> 11) * 0x1p-53;
    return points;
}

/// Nested uniform scrambling in base 2 [Owen 1995], one coordinate of all points: every digit is flipped or not by a
/// fair coin that belongs to the digits before it. Each point becomes uniform; points that shared k digits still share
/// exactly k, so nets stay nets. Only coins that some point sees are thrown: O(n log n).
void owen_scramble(std::vector<std::uint64_t>& coordinate, RandomStream& random);

/// owen_scramble on each axis, independently.
template <int D>
std::vector<BinaryPoint<D>> owen_scrambled(std::vector<BinaryPoint<D>> digits, RandomStream& random) {
    std::vector<std::uint64_t> coordinate(digits.size());
    for (int axis = 0; axis < D; ++axis) {
        for (std::size_t i = 0; i < digits.size(); ++i) coordinate[i] = digits[i][axis];
        owen_scramble(coordinate, random);
        for (std::size_t i = 0; i < digits.size(); ++i) digits[i][axis] = coordinate[i];
    }
    return digits;
}

/// Random digit scrambling [Kollig & Keller 2002]: the same random digits are added (xor) to every point, a shift in
/// base 2. Each point becomes uniform and nets stay nets, at one xor a coordinate, but errors do not average out.
template <int D>
std::vector<BinaryPoint<D>> digit_shifted(std::vector<BinaryPoint<D>> digits, RandomStream& random) {
    BinaryPoint<D> shift;
    for (std::uint64_t& s : shift) s = random.bits();
    for (BinaryPoint<D>& point : digits)
        for (int axis = 0; axis < D; ++axis) point[axis] ^= shift[axis];
    return digits;
}

}  // namespace plumb
