#pragma once

// Multi-precision, by MPFR: expensive to compile, so only a few .cpp files include it.

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <map>

#include "analytic/formulas/elementary.h"

namespace plumb {

template <unsigned Digits>
using Decimal = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
/// 80 decimal digits: answers are stated to 50, and differences of two near numbers have 30 to lose.
using Real = Decimal<80>;

namespace formulas {

template <unsigned Digits>
struct Elementary<Decimal<Digits>> {
    using R = Decimal<Digits>;

    static const R& pi() {
        static const R value = boost::math::constants::pi<R>();
        return value;
    }
    static R erf(const R& x) {
        R value;
        mpfr_erf(value.backend().data(), x.backend().data(), MPFR_RNDN);
        return value;
    }
    static R erfc(const R& x) {
        R value;
        mpfr_erfc(value.backend().data(), x.backend().data(), MPFR_RNDN);
        return value;
    }
    /// Remembers what it has computed: a product rule asks for its few nodes again and again.
    static R normal_quantile(const R& u) {
        thread_local std::map<R, R> known;
        const auto [found, is_new] = known.try_emplace(u);
        if (is_new) found->second = u > R(1) / 2 ? R(-lower_quantile(R(1 - u))) : lower_quantile(u);
        return found->second;
    }

private:
    /// Halley's iteration on Φ(z) = u, from the double's quantile: each step triples the digits.
    static R lower_quantile(const R& u) {
        static const R root_two = sqrt(R(2)), density_at_zero = 1 / sqrt(2 * pi());
        R z = Elementary<double>::normal_quantile(static_cast<double>(u));
        for (unsigned digits = 14; digits < Digits; digits *= 3) {
            const R newton = (erfc(R(-z / root_two)) / 2 - u) / (density_at_zero * exp(R(-z * z / 2)));
            z -= newton / (1 + z * newton / 2);
        }
        return z;
    }
};

}  // namespace formulas
}  // namespace plumb
