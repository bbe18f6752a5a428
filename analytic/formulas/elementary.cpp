#include "analytic/formulas/elementary.h"

#include <boost/math/special_functions/erf.hpp>
#include <limits>

namespace plumb::formulas {

double Elementary<double>::normal_quantile(double u) {
    using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
    if (u <= 0) return -std::numeric_limits<double>::infinity();
    if (u >= 1) return std::numeric_limits<double>::infinity();
    return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * u, Policy());
}

}  // namespace plumb::formulas
