#include "estimators/estimator.h"

#include "core/named.h"

namespace plumb {

template <>
const std::vector<Estimator<1>>& estimators<1>() {
    return estimators_1d();
}
template <>
const std::vector<Estimator<2>>& estimators<2>() {
    return estimators_2d();
}

template <int D>
const Estimator<D>& find_estimator(std::string_view id) {
    return find_named(estimators<D>(), id, D == 1 ? "1D estimator" : "2D estimator");
}
template const Estimator<1>& find_estimator<1>(std::string_view);
template const Estimator<2>& find_estimator<2>(std::string_view);

}  // namespace plumb
