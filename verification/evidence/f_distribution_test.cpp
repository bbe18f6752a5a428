#include "verification/evidence/f_distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

TEST(FTail, AgreesWithClosedForms) {
    // Of 2 and n degrees: (1 + 2x/n)^(-n/2); of 1 and n: the square of Student's t.
    for (const double n : {1.0, 7.0, 30.0, 400.0})
        for (const double x : {0.1, 1.0, 5.0, 40.0}) {
            const double exact = std::pow(1 + 2 * x / n, -n / 2);
            EXPECT_NEAR(f_tail(x, 2, n) / exact, 1, 1e-10) << n << " " << x;
            EXPECT_NEAR(f_tail(x, 1, n) / student_two_sided_tail(std::sqrt(x), n), 1, 1e-10) << n << " " << x;
        }
}

TEST(FTail, IsChiSquaresWhereTheSecondIsKnown) {
    constexpr double known = std::numeric_limits<double>::infinity();
    EXPECT_DOUBLE_EQ(f_tail(1.5, 20, known), chi_square_tail(30, 20));
    EXPECT_NEAR(f_tail(1.5, 20, 1e9) / f_tail(1.5, 20, known), 1, 1e-6);
}

}  // namespace
}  // namespace plumb
