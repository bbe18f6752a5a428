// The lists of all estimators, joined from those of each family.
#include "estimators/estimator.h"
#include "estimators/mis/importance_estimators.h"
#include "estimators/points/point_set_estimators.h"
#include "estimators/reweighting/reweighting_estimators_1d.h"
#include "estimators/reweighting/reweighting_estimators_2d.h"

namespace plumb {
namespace {

template <class T>
std::vector<T> joined(std::initializer_list<std::vector<T>> lists) {
    std::vector<T> all;
    for (const std::vector<T>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace

const std::vector<Estimator<1>>& estimators_1d() {
    static const auto all = joined({
        point_set_estimators_1d(),
        importance_estimators_1d(),
        reweighting_estimators_1d(),
    });
    return all;
}

const std::vector<Estimator<2>>& estimators_2d() {
    static const auto all = joined({
        point_set_estimators_2d(),
        importance_estimators_2d(),
        reweighting_estimators_2d(),
    });
    return all;
}

}  // namespace plumb
