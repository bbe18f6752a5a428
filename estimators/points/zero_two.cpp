#include "estimators/points/zero_two.h"

#include "estimators/points/point_count.h"

namespace plumb {

std::vector<BinaryPoint<2>> zero_two_digits(std::uint64_t n) {
    std::vector<BinaryPoint<2>> digits(point_count(n, "zero-two"));
    for (std::size_t i = 0; i < digits.size(); ++i) {
        // Columns of the generator matrices, one for each binary digit of i: the identity, and Pascal's triangle mod 2,
        // whose next column is the last one xor itself moved down by a row.
        std::uint64_t identity = std::uint64_t{1} << 63, pascal = identity;
        for (std::size_t rest = i; rest > 0; rest >>= 1, identity >>= 1, pascal ^= pascal >> 1)
            if (rest & 1) {
                digits[i][0] ^= identity;
                digits[i][1] ^= pascal;
            }
    }
    return digits;
}

std::vector<Point<2>> zero_two(std::uint64_t n) {
    return to_points<2>(zero_two_digits(n));
}
std::vector<Point<2>> xor_zero_two(std::uint64_t n, RandomStream& random) {
    return to_points<2>(digit_shifted<2>(zero_two_digits(n), random));
}
std::vector<Point<2>> owen_zero_two(std::uint64_t n, RandomStream& random) {
    return to_points<2>(owen_scrambled<2>(zero_two_digits(n), random));
}

}  // namespace plumb
