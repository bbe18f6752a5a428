#include "estimators/points/sobol.h"

#include <boost/random/sobol.hpp>

#include "estimators/points/point_count.h"

namespace plumb {

template <int D>
std::vector<BinaryPoint<D>> sobol_digits(std::uint64_t n) {
    std::vector<BinaryPoint<D>> digits(point_count(n, "sobol"));  // the first stays zero
    boost::random::sobol_engine<std::uint32_t, 32> engine(D);
    for (std::size_t i = 1; i < digits.size(); ++i)
        for (std::uint64_t& x : digits[i]) x = std::uint64_t{engine()} << 32;
    return digits;
}
template std::vector<BinaryPoint<1>> sobol_digits<1>(std::uint64_t);
template std::vector<BinaryPoint<2>> sobol_digits<2>(std::uint64_t);

std::vector<Point<1>> sobol_1d(std::uint64_t n) {
    return to_points<1>(sobol_digits<1>(n));
}
std::vector<Point<2>> sobol_2d(std::uint64_t n) {
    return to_points<2>(sobol_digits<2>(n));
}

std::vector<Point<1>> owen_sobol_1d(std::uint64_t n, RandomStream& random) {
    return to_points<1>(owen_scrambled<1>(sobol_digits<1>(n), random));
}
std::vector<Point<2>> owen_sobol_2d(std::uint64_t n, RandomStream& random) {
    return to_points<2>(owen_scrambled<2>(sobol_digits<2>(n), random));
}

}  // namespace plumb
