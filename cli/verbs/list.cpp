#include <CLI/CLI.hpp>

#include "cli/session.h"
#include "cli/verb.h"
#include "cli/verbs/lists.h"
#include "core/named.h"
#include "verification/claim.h"

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

std::vector<reports::ListRow> list_of(const Lists& lists) {
    std::vector<reports::ListRow> rows;
    for (const auto& [name, rows_of] : lists)
        rows.push_back({{"list", name}, {"entries", static_cast<std::uint64_t>(rows_of().size())}});
    return rows;
}

}  // namespace

Lists catalogue_lists(const Catalogue& catalogue) {
    return {{"claims", [&] { return claim_rows(catalogue); }}, {"mutants", [&] { return mutant_rows(catalogue); }}};
}

Action add_list(CLI::App& verb, const std::string& names, Lists (*lists)(const Catalogue&)) {
    struct Options {
        std::string what;
        bool json = false;
    };
    const auto options = std::make_shared<Options>();
    verb.add_option("what", options->what, names + "; when not given, which lists there are");
    verb.add_flag("--json", options->json, "print the list as JSON");
    return [options, lists](const Catalogue& catalogue) {
        const Lists all = lists(catalogue);
        const std::vector<reports::ListRow> rows =
            options->what.empty() ? list_of(all)
                                  : find_named(all, options->what, "list", &Lists::value_type::first).second();
        fmt::print("{}", options->json ? reports::list_json(rows) : reports::list_table(rows, terminal_style()));
        return 0;
    };
}

namespace verbs {

Verb list() {
    return {"list", "List what Plumb knows", [](CLI::App& verb) {
                verb.footer("Example: list claims --json");
                return add_list(verb, "claims or mutants", catalogue_lists);
            }};
}

}  // namespace verbs
}  // namespace plumb::cli
