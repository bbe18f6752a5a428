#include "estimators/estimator.h"

#include "core/error.h"

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
    std::vector<std::string> known;
    for (const Estimator<D>& estimator : estimators<D>()) {
        if (estimator.id == id) return estimator;
        known.push_back(estimator.id);
    }
    throw unknown_name(D == 1 ? "1D estimator" : "2D estimator", id, known);
}
template const Estimator<1>& find_estimator<1>(std::string_view);
template const Estimator<2>& find_estimator<2>(std::string_view);

}  // namespace plumb
