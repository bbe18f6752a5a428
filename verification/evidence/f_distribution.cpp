#include "verification/evidence/f_distribution.h"

#include <boost/math/distributions/complement.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "verification/evidence/distributions.h"

namespace plumb {

double f_tail(double x, double m, double n) {
    if (std::isinf(n)) return chi_square_tail(x * m, m);
    return boost::math::cdf(boost::math::complement(boost::math::fisher_f_distribution<>(m, n), x));
}

}  // namespace plumb
