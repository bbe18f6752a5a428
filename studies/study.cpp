#include "studies/study.h"

#include <functional>

#include "core/named.h"

namespace plumb {
namespace {

/// The study's own first.
template <int D>
std::vector<std::reference_wrapper<const Estimator<D>>> all_estimators(const Study& study) {
    std::vector<std::reference_wrapper<const Estimator<D>>> all;
    for (const auto* list : {&own_estimators<D>(study), &estimators<D>()})
        all.insert(all.end(), list->begin(), list->end());
    return all;
}

}  // namespace

template <int D>
const Estimator<D>& find_estimator(const Study& study, std::string_view id) {
    return find_named(all_estimators<D>(study), id, D == 1 ? "1D estimator" : "2D estimator", &Estimator<D>::id);
}
template const Estimator<1>& find_estimator<1>(const Study&, std::string_view);
template const Estimator<2>& find_estimator<2>(const Study&, std::string_view);

template <int D>
bool knows_estimator(const Study& study, std::string_view id) {
    return std::ranges::any_of(all_estimators<D>(study), [&](const Estimator<D>& known) { return known.id == id; });
}
template bool knows_estimator<1>(const Study&, std::string_view);
template bool knows_estimator<2>(const Study&, std::string_view);

SceneMethod find_scene_method(const Study& study, const std::string& id) {
    const auto own = std::ranges::find(study.scene_methods, id, &SceneMethod::id);
    return own == study.scene_methods.end() ? scene_method(id) : *own;
}

template <int D>
bool knows_integrand(std::string_view id) {
    return std::ranges::any_of(integrands<D>(), [&](const Integrand<D>& f) { return f.id == id; });
}
template bool knows_integrand<1>(std::string_view);
template bool knows_integrand<2>(std::string_view);

}  // namespace plumb
