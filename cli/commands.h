#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/options.h"
#include "reports/run/json.h"
#include "verification/claim.h"

namespace plumb {
class Scene;
}

namespace plumb::cli {

/// What `list` can show: a name and its rows.
using Lists = std::map<std::string, std::function<std::vector<reports::ListRow>()>>;
/// Claims and mutants of the catalogue, which must outlive the lists.
Lists catalogue_lists(const Catalogue& catalogue);
/// These, integrands and estimators.
Lists shipped_lists(const Catalogue& catalogue);

/// The verbs: each does its work, prints to standard output and returns the program's exit code. Throws Error.
int check(const CheckOptions& options);
int verify(const VerifyOptions& options, const Catalogue& catalogue);
int list(const ListOptions& options, const Lists& lists);
int converge(const ConvergeOptions& options);
int study(const StudyOptions& options);
int study_calibration(const StudyOptions& options);  ///< the study of that name: what a verdict costs
int reference(const ReferenceOptions& options);
int render(const RenderOptions& options);
int render(const RenderOptions& options, const std::function<Scene()>& load);  ///< a scene that is not to be read again
int explain(const ExplainOptions& options);
int compare(const CompareOptions& options);
int integrate(const IntegrateOptions& options);
int weights(const WeightsOptions& options);
int report(const ReportOptions& options);
int merge(const MergeOptions& options);
int merge_films(const MergeOptions& options);  ///< into an image

/// Of a verb that ends in one verdict.
constexpr int exit_code(Outcome outcome) {
    return outcome == Outcome::holds ? 0 : outcome == Outcome::refuted ? 1 : 3;
}

}  // namespace plumb::cli
