#include "scenes/film/exact_sum.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace plumb {
namespace {

/// By one conversion of 128 bits, which rounds x to a multiple of the resolution once.
ExactSum::Integer rounded(double x) {
    return static_cast<ExactSum::Integer>(std::nearbyint(x / ExactSum::resolution));
}

void expect_rounded(double x) {
    ASSERT_TRUE(ExactSum::accepts(x)) << x;
    ExactSum sum;
    sum.add(x);
    EXPECT_TRUE(sum.bits() == rounded(x)) << x;
}

void expect_all_rounded(int term_bits) {
    RandomStream random(1, 2);
    for (int exponent = -80; exponent <= term_bits; ++exponent)
        for (int i = 0; i < 100; ++i) {
            const double x = std::ldexp(0.5 + random.uniform() / 2, exponent);
            expect_rounded(x);
            expect_rounded(-x);
        }
    // Ties go to the even neighbour, whatever part the bits on either side of it belong to.
    for (const double units : {0.5, 1.5, 2.5, 0x1p40 + 0.5, 0x1p43 - 0.5, 0x1p43 + 0.5, 0x1p32 - 1.5, 0x1p33 + 1.5}) {
        expect_rounded(units * ExactSum::resolution);
        expect_rounded(-units * ExactSum::resolution);
    }
    expect_rounded(0);
    expect_rounded(std::nextafter(std::ldexp(1.0, term_bits), 0));
}

TEST(ExactSum, RoundsEachTermOnce) {
    expect_all_rounded(31);
}

}  // namespace
}  // namespace plumb
