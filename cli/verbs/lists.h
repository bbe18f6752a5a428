#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/verb.h"
#include "reports/run/json.h"

namespace plumb::cli {

/// What `list` can show: a name and its rows.
using Lists = std::map<std::string, std::function<std::vector<reports::ListRow>()>>;

/// The lists of claims and mutants of the catalogue, which must outlive them.
Lists catalogue_lists(const Catalogue& catalogue);

/// The options of a verb that shows these lists; `names` says in its help what there is.
Action add_list(CLI::App& verb, const std::string& names, Lists (*lists)(const Catalogue&));

}  // namespace plumb::cli
