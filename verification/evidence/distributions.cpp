#include "verification/evidence/distributions.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/complement.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace plumb {

namespace math = boost::math;

double normal_upper_quantile(double tail) {
    return math::quantile(math::complement(math::normal(), tail));
}

double normal_two_sided_tail(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.0));
}

double student_two_sided_tail(double t, double degrees_of_freedom) {
    return 2 * math::cdf(math::complement(math::students_t(degrees_of_freedom), std::abs(t)));
}

double student_upper_quantile(double tail, double degrees_of_freedom) {
    return math::quantile(math::complement(math::students_t(degrees_of_freedom), tail));
}

double chi_square_lower_tail(double x, double degrees_of_freedom) {
    return math::cdf(math::chi_squared(degrees_of_freedom), x);
}

double chi_square_tail(double x, double degrees_of_freedom) {
    return math::cdf(math::complement(math::chi_squared(degrees_of_freedom), x));
}

double chi_square_upper_quantile(double tail, double degrees_of_freedom) {
    return math::quantile(math::complement(math::chi_squared(degrees_of_freedom), tail));
}

double noncentrality_upper_bound(double x, double degrees_of_freedom, double beta) {
    if (math::cdf(math::chi_squared(degrees_of_freedom), x) <= beta) return 0;
    // Far beyond what Boost's series reaches: one coordinate is as short as the whole vector or shorter, so
    // P(X ≤ x) ≤ P(Z ≤ sqrt(x) − sqrt(noncentrality)).
    if (x > 1e8) return std::pow(std::sqrt(x) + normal_upper_quantile(beta), 2);
    return math::non_central_chi_squared::find_non_centrality(degrees_of_freedom, x, beta);
}

Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double tail) {
    const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
    Interval p{0, 1};
    if (successes > 0) p.low = math::quantile(math::beta_distribution<>(k, n - k + 1), tail);
    if (successes < trials) p.high = math::quantile(math::complement(math::beta_distribution<>(k + 1, n - k), tail));
    return p;
}

}  // namespace plumb
