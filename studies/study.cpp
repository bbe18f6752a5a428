#include "studies/study.h"

#include "core/error.h"

namespace plumb {
namespace {

template <int D>
const Estimator<D>* look_up(const Study& study, std::string_view id) {
    for (const auto* list : {&own_estimators<D>(study), &estimators<D>()})
        for (const Estimator<D>& estimator : *list)
            if (estimator.id == id) return &estimator;
    return nullptr;
}

}  // namespace

template <int D>
const Estimator<D>& find_estimator(const Study& study, std::string_view id) {
    if (const Estimator<D>* found = look_up<D>(study, id)) return *found;
    std::vector<std::string> known;
    for (const auto* list : {&own_estimators<D>(study), &estimators<D>()})
        for (const Estimator<D>& estimator : *list) known.push_back(estimator.id);
    throw unknown_name(D == 1 ? "1D estimator" : "2D estimator", id, known);
}
template const Estimator<1>& find_estimator<1>(const Study&, std::string_view);
template const Estimator<2>& find_estimator<2>(const Study&, std::string_view);

template <int D>
bool knows_estimator(const Study& study, std::string_view id) {
    return look_up<D>(study, id) != nullptr;
}
template bool knows_estimator<1>(const Study&, std::string_view);
template bool knows_estimator<2>(const Study&, std::string_view);

template <int D>
bool knows_integrand(std::string_view id) {
    return std::ranges::any_of(integrands<D>(), [&](const Integrand<D>& f) { return f.id == id; });
}
template bool knows_integrand<1>(std::string_view);
template bool knows_integrand<2>(std::string_view);

}  // namespace plumb
