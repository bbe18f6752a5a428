#include "analytic/integrand.h"
#include "cli/commands.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "estimators/estimator.h"
#include "reports/json.h"
#include "reports/table.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

std::string sizes_of(const Claim& claim) {
    switch (claim.sizes) {
        case Sizes::both: return "quick, full";
        case Sizes::quick_only: return "quick";
        case Sizes::full_only: return "full";
    }
    throw std::logic_error("Sizes outside its enumeration");
}

std::vector<ListRow> claim_rows() {
    std::vector<ListRow> rows;
    const Catalogue catalogue = shipped_catalogue();
    for (const Claim& claim : catalogue.claims())
        rows.push_back({{"id", claim.id},
                        {"kind", to_string(claim.kind)},
                        {"statement", claim.statement},
                        {"source", claim.source},
                        {"sizes", sizes_of(claim)},
                        {"mutants", static_cast<std::uint64_t>(claim.mutants.size())},
                        {"no_mutant", claim.no_mutant}});
    return rows;
}

std::vector<ListRow> mutant_rows() {
    std::vector<ListRow> rows;
    const Catalogue catalogue = shipped_catalogue();
    for (const Claim& claim : catalogue.claims())
        for (const Mutant& mutant : claim.mutants)
            rows.push_back({{"id", claim.id + "/" + mutant.id}, {"of", claim.id}, {"defect", mutant.defect}});
    return rows;
}

template <int D>
void append_integrands(std::vector<ListRow>& rows) {
    for (const Integrand<D>& f : integrands<D>())
        rows.push_back({{"id", f.id},
                        {"dimension", std::uint64_t{D}},
                        {"formula", f.formula},
                        {"integral", f.integral},
                        {"variance", f.variance_value()},
                        {"smoothness", to_string(f.smoothness)},
                        {"periodic_smoothness", to_string(f.periodic_smoothness)},
                        {"source", f.source},
                        {"derivation", f.derivation}});
}

template <int D>
void append_estimators(std::vector<ListRow>& rows) {
    for (const Estimator<D>& e : estimators<D>())
        rows.push_back({{"id", e.id},
                        {"dimension", std::uint64_t{D}},
                        {"unbiased", std::string(e.unbiased ? "yes" : "no")},
                        {"summary", e.summary},
                        {"source", e.source}});
}

std::vector<ListRow> rows_of(const std::string& what) {
    if (what == "claims") return claim_rows();
    if (what == "mutants") return mutant_rows();
    std::vector<ListRow> rows;
    if (what == "integrands") {
        append_integrands<1>(rows);
        append_integrands<2>(rows);
    } else if (what == "estimators") {
        append_estimators<1>(rows);
        append_estimators<2>(rows);
    } else {
        throw unknown_name("list", what, {"claims", "mutants", "integrands", "estimators"});
    }
    return rows;
}

}  // namespace

int list(const ListOptions& options) {
    const std::vector<ListRow> rows = rows_of(options.what);
    fmt::print("{}", options.json ? list_json(rows) : list_table(rows, terminal_style()));
    return 0;
}

}  // namespace plumb
