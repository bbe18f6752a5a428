#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace plumb {

/// A sum that does not depend on the order of its terms: fixed point in 128 bits, each term rounded once to a multiple
/// of 2^-fraction_bits. Terms have magnitudes below 2^term_bits; 2^(126 − fraction_bits − term_bits) of them cannot
/// overflow.
template <int fraction_bits, int term_bits>
class FixedPointSum {
public:
    static_assert(fraction_bits + term_bits > 63 && fraction_bits + term_bits <= 106);

    static constexpr double resolution = 1 / static_cast<double>(__extension__(__int128){1} << fraction_bits);
    /// Whether x can be a term; NaN cannot.
    static bool accepts(double x) { return std::abs(x) < std::ldexp(1.0, term_bits); }
    /// x must be accepted.
    void add(double x) {
        // In two parts of 64 bits, because processors convert no more. Both are exact but for the one rounding: the
        // upper part is whole, and even in units of the lower one.
        const double places = x * upper_scale;
        const auto upper = static_cast<std::int64_t>(places);
        const double rest = (places - static_cast<double>(upper)) * lower_scale;
        sum_ += (Integer{upper} * lower_units) + static_cast<std::int64_t>(std::nearbyint(rest));
    }
    void merge(const FixedPointSum& other) { sum_ += other.sum_; }
    __extension__ using Integer = __int128;
    /// The sum in multiples of 2^-fraction_bits.
    [[nodiscard]] Integer bits() const { return sum_; }
    /// The sum rounded once.
    [[nodiscard]] double value() const { return static_cast<double>(sum_) / scale; }
    friend bool operator==(const FixedPointSum&, const FixedPointSum&) = default;

private:
    static constexpr double scale = static_cast<double>(Integer{1} << fraction_bits);
    static constexpr int upper_bits = 63 - term_bits;  // behind the point, so that no term has more than 63
    static constexpr double upper_scale = static_cast<double>(Integer{1} << upper_bits);
    static constexpr std::int64_t lower_units = std::int64_t{1} << (fraction_bits - upper_bits);
    static constexpr double lower_scale = static_cast<double>(lower_units);
    Integer sum_ = 0;
};

/// A sum of radiances and the like, in a unit of their size: resolution 5e-20, terms below 2^31, 2^31 of them.
using ExactSum = FixedPointSum<64, 31>;

}  // namespace plumb
