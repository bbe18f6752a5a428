#include "cli/commands.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "reports/run/json.h"
#include "reports/run/table.h"

namespace plumb::cli {
namespace {

std::string sizes_of(const Claim& claim) {
    switch (claim.sizes) {
        case Sizes::both: return "quick, full";
        case Sizes::quick_only: return "quick";
        case Sizes::full_only: return "full";
    }
    throw std::logic_error("Sizes outside its enumeration");
}

std::vector<reports::ListRow> claim_rows(const Catalogue& catalogue) {
    std::vector<reports::ListRow> rows;
    for (const Claim& claim : catalogue.claims())
        rows.push_back({{"id", claim.id},
                        {"kind", to_string(claim.kind)},
                        {"statement", claim.statement},
                        {"source", claim.source},
                        {"sizes", sizes_of(claim)},
                        {"mutants", static_cast<std::uint64_t>(claim.trial.mutants().size())},
                        {"no_mutant", claim.no_mutant}});
    return rows;
}

std::vector<reports::ListRow> mutant_rows(const Catalogue& catalogue) {
    std::vector<reports::ListRow> rows;
    for (const Claim& claim : catalogue.claims())
        for (const Mutant& mutant : claim.trial.mutants())
            rows.push_back({{"id", claim.id + "/" + mutant.id}, {"of", claim.id}, {"defect", mutant.defect}});
    return rows;
}

}  // namespace

Lists catalogue_lists(const Catalogue& catalogue) {
    return {{"claims", [&] { return claim_rows(catalogue); }}, {"mutants", [&] { return mutant_rows(catalogue); }}};
}

int list(const ListOptions& options, const Lists& lists) {
    const auto found = lists.find(options.what);
    if (found == lists.end()) {
        std::vector<std::string> known;
        for (const auto& [name, rows] : lists) known.push_back(name);
        throw unknown_name("list", options.what, known);
    }
    const std::vector<reports::ListRow> rows = found->second();
    fmt::print("{}", options.json ? reports::list_json(rows) : reports::list_table(rows, terminal_style()));
    return 0;
}

}  // namespace plumb::cli
