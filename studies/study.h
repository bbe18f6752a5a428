#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "estimators/estimator.h"
#include "reports/study/study_result.h"
#include "studies/headline.h"
#include "studies/scene_method.h"
#include "studies/scene_part.h"

namespace plumb {

/// The work that a replicate may take: counts of samples, or of evaluations of the integrand (then each estimator gets
/// the largest n that stays within).
struct Budget {
    enum class Unit { samples, evaluations } unit = Unit::samples;
    std::vector<std::uint64_t> counts;
};

struct FigurePlan {
    reports::FigureText about;
    std::vector<std::string> estimators, integrands;  ///< every one on every one; scenes may stand for integrands
    std::string reference = {};                       ///< of scenes, see SceneMeasure
    Budget budget;
    std::uint64_t replicates = 1000;
};

/// The subjects of a study and what it compares: the value of its file (docs/studies.md).
struct Study {
    reports::StudyText about;
    std::optional<std::uint64_t> seed;
    std::vector<Estimator<1>> estimators_1d;  ///< its own, beside the shipped ones
    std::vector<Estimator<2>> estimators_2d;
    std::vector<SceneMethod> scene_methods;
    std::vector<ScenePart> scene_parts;  ///< that stand for integrands in its figures
    std::vector<FigurePlan> figures;
    std::vector<HeadlinePlan> headlines;
};

template <int D>
auto& own_estimators(auto& study) {
    if constexpr (D == 1)
        return study.estimators_1d;
    else
        return study.estimators_2d;
}

/// An estimator of the study's own, or a shipped one; throws Error naming the nearest one.
template <int D>
const Estimator<D>& find_estimator(const Study& study, std::string_view id);

/// A method of the study's own, or the one that scene_method() makes of the id.
SceneMethod find_scene_method(const Study& study, const std::string& id);

template <int D>
bool knows_estimator(const Study& study, std::string_view id);
template <int D>
bool knows_integrand(std::string_view id);

}  // namespace plumb
