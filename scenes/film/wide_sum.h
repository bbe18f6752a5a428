#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "scenes/film/exact_sum.h"

namespace plumb {

/// A sum that does not depend on the order of its terms: fixed point in 64 · limb_count bits, each term rounded once to
/// a multiple of 2^-fraction_bits. A term that is not finite makes the sum so.
template <int fraction_bits, int limb_count>
class LimbSum {
public:
    static constexpr double resolution = [] {
        double r = 1;
        for (int i = 0; i < fraction_bits; ++i) r /= 2;
        return r;
    }();
    /// Whether 2^27 terms like x cannot overflow; NaN is none.
    static bool accepts(double x) { return std::abs(x) < std::ldexp(1.0, 64 * limb_count - fraction_bits - 28); }
    void add(double x);
    template <int bits, int term_bits>
    requires(bits <= fraction_bits) void add(const FixedPointSum<bits, term_bits>& sum) {
        add(sum.bits(), fraction_bits - bits);
    }
    /// Adds a sum with more digits; those beyond this one's are cut off.
    template <int bits, int count>
    requires(bits >= fraction_bits && (bits - fraction_bits) % 64 == 0) void add(const LimbSum<bits, count>& finer) {
        constexpr int beyond = (bits - fraction_bits) / 64;
        Limbs term{};
        for (int i = 0; i < limb_count; ++i)
            term[static_cast<std::size_t>(i)] = finer.limb(static_cast<std::size_t>(i + beyond));
        add_limbs(term);
        not_finite_ += finer.not_finite();
    }
    void merge(const LimbSum& other);
    /// The sum rounded once, to nearest even; infinite where it is beyond the doubles.
    [[nodiscard]] double value() const;

    /// 64 of the bits, the lowest first; those above all are of the sign.
    [[nodiscard]] std::uint64_t limb(std::size_t i) const {
        return i < sum_.size() ? sum_[i] : sum_.back() >> 63 != 0 ? ~std::uint64_t{0} : 0;
    }
    /// The sum of the terms that are not finite; 0 without any.
    [[nodiscard]] double not_finite() const { return not_finite_; }

private:
    using Limbs = std::array<std::uint64_t, limb_count>;  // two's complement, the lowest first
    __extension__ using Integer = __int128;

    void add(Integer digits, int shift);
    void add_limbs(const Limbs& term);

    Limbs sum_{};
    double not_finite_ = 0;
};

/// A sum of any doubles, from 2^-64 up to 2^1087; 2^62 terms cannot overflow.
using WideSum = LimbSum<64, 18>;
/// A sum of squares of what an ExactSum keeps: resolution 3e-39, terms below 2^100.
using ExactSumOfSquares = LimbSum<128, 4>;

extern template class LimbSum<64, 18>;
extern template class LimbSum<128, 4>;

/// The terms that do not fit into the many exact sums of a film, by the sums' numbers: slow and large, meant for few.
class WideSums {
public:
    void add(std::size_t number, double x) { sums_[number].add(x); }
    void merge(std::size_t number, const WideSum& sum) { sums_[number].merge(sum); }
    void merge(const WideSums& other) {
        for (const auto& [number, sum] : other.sums_) merge(number, sum);
    }
    /// The total of the exact sum of this number and of what did not fit into it.
    template <class Exact>
    [[nodiscard]] double total(std::size_t number, const Exact& exact) const {
        return sums_.empty() ? exact.value() : total_with_wide(number, exact);
    }
    [[nodiscard]] const std::map<std::size_t, WideSum>& sums() const { return sums_; }

private:
    template <class Exact>
    [[nodiscard]] double total_with_wide(std::size_t number, const Exact& exact) const {
        const auto found = sums_.find(number);
        if (found == sums_.end()) return exact.value();
        WideSum sum = found->second;
        sum.add(exact);
        return sum.value();
    }

    std::map<std::size_t, WideSum> sums_;
};

}  // namespace plumb
