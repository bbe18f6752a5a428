#include "analytic/integrand.h"

#include "core/named.h"

namespace plumb {

std::string to_string(Smoothness smoothness) {
    switch (smoothness) {
        case Smoothness::analytic: return "analytic";
        case Smoothness::kink: return "kink";
        case Smoothness::root: return "root";
        case Smoothness::jump: return "jump";
        case Smoothness::singular: return "singular";
    }
    throw std::logic_error("a Smoothness outside its enumeration");
}

template <>
const std::vector<Integrand<1>>& integrands<1>() {
    return integrands_1d();
}
template <>
const std::vector<Integrand<2>>& integrands<2>() {
    return integrands_2d();
}

template <int D>
const Integrand<D>& find_integrand(std::string_view id) {
    return find_named(integrands<D>(), id, D == 1 ? "1D integrand" : "2D integrand");
}
template const Integrand<1>& find_integrand<1>(std::string_view);
template const Integrand<2>& find_integrand<2>(std::string_view);

template <int D>
double Integrand<D>::root_mean_square() const {
    const double mean = integral_value();
    return std::sqrt(variance_value() + mean * mean);
}
template double Integrand<1>::root_mean_square() const;
template double Integrand<2>::root_mean_square() const;

}  // namespace plumb
