#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "scenes/film/exact_sum.h"

namespace plumb {

/// A sum of any doubles that does not depend on their order: fixed point in 1152 bits, from 2^-64 up to 2^1087, each
/// term rounded once to a multiple of 2^-64; 2^62 terms cannot overflow. A term that is not finite makes the sum so.
class WideSum {
public:
    void add(double x);
    template <int fraction_bits, int term_bits>
    void add(const FixedPointSum<fraction_bits, term_bits>& sum) {
        add(sum.bits(), fraction - fraction_bits);
    }
    void merge(const WideSum& other);
    /// The sum rounded once, to nearest even; infinite where it is beyond the doubles.
    [[nodiscard]] double value() const;

private:
    static constexpr int fraction = 64, limbs = 18;
    using Limbs = std::array<std::uint64_t, limbs>;  // two's complement, the lowest first
    __extension__ using Integer = __int128;

    void add(Integer digits, int shift);

    Limbs sum_{};
    double not_finite_ = 0;
};

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
