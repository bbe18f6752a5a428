#include "scenes/film/wide_sum.h"

namespace plumb {

namespace {

__extension__ using Wide = unsigned __int128;

// a += b + carry; returns the carry out.
bool add_with_carry(std::uint64_t& a, std::uint64_t b, bool carry) {
    const Wide sum = static_cast<Wide>(a) + b + carry;
    a = static_cast<std::uint64_t>(sum);
    return sum >> 64 != 0;
}

template <class Limbs>
void add_to(Limbs& sum, const Limbs& term) {
    bool carry = false;
    for (std::size_t i = 0; i < sum.size(); ++i) carry = add_with_carry(sum[i], term[i], carry);
}

template <class Limbs>
Limbs negated(Limbs sum) {
    bool carry = true;
    for (std::uint64_t& limb : sum) carry = add_with_carry(limb = ~limb, 0, carry);
    return sum;
}

}  // namespace

// Adds digits · 2^(shift − fraction_bits), shift ≥ 0.
template <int fraction_bits, int limb_count>
void LimbSum<fraction_bits, limb_count>::add(Integer digits, int shift) {
    const bool negative = digits < 0;
    const Wide magnitude = negative ? -static_cast<Wide>(digits) : static_cast<Wide>(digits);
    const Wide low = static_cast<Wide>(static_cast<std::uint64_t>(magnitude)) << shift % 64;
    const Wide high = (magnitude >> 64) << shift % 64;
    Limbs term{};
    auto at = static_cast<std::size_t>(shift / 64);
    term[at] = static_cast<std::uint64_t>(low);
    const Wide middle =
        (low >> 64) + static_cast<std::uint64_t>(high);  // high's lowest bits are 0 where low >> 64 is not
    if (++at < term.size()) term[at] = static_cast<std::uint64_t>(middle);
    if (++at < term.size()) term[at] = static_cast<std::uint64_t>(high >> 64);
    add_to(sum_, negative ? negated(term) : term);
}

template <int fraction_bits, int limb_count>
void LimbSum<fraction_bits, limb_count>::add_limbs(const Limbs& term) {
    add_to(sum_, term);
}

template <int fraction_bits, int limb_count>
void LimbSum<fraction_bits, limb_count>::add(double x) {
    if (!std::isfinite(x)) {
        not_finite_ += x;
        return;
    }
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);  // x = mantissa 2^exponent, |mantissa| in [½, 1)
    const int shift = exponent - 53 + fraction_bits;   // of its 53 digits
    if (shift >= 0)
        add(static_cast<Integer>(std::ldexp(mantissa, 53)), shift);
    else
        add(static_cast<Integer>(std::nearbyint(std::ldexp(x, fraction_bits))), 0);
}

template <int fraction_bits, int limb_count>
void LimbSum<fraction_bits, limb_count>::merge(const LimbSum& other) {
    add_to(sum_, other.sum_);
    not_finite_ += other.not_finite_;
}

template <int fraction_bits, int limb_count>
double LimbSum<fraction_bits, limb_count>::value() const {
    if (not_finite_ != 0) return not_finite_;
    const bool negative = sum_.back() >> 63 != 0;
    const Limbs magnitude = negative ? negated(sum_) : sum_;
    std::size_t top = magnitude.size() - 1;
    while (top > 1 && magnitude[top] == 0) --top;
    Wide digits = static_cast<Wide>(magnitude[top]) << 64 | magnitude[top - 1];
    // What lies below can tip a tie alone: as the lowest bit, far under the 53 digits that are kept. Where the top limb
    // is 0 there is nothing below.
    for (std::size_t i = 0; i + 1 < top; ++i)
        if (magnitude[i] != 0) digits |= 1;
    const double value = std::ldexp(static_cast<double>(digits), 64 * static_cast<int>(top - 1) - fraction_bits);
    return negative ? -value : value;
}

template class LimbSum<64, 18>;
template class LimbSum<128, 4>;

}  // namespace plumb
