#include "cli/verbs.h"
#include "verification/suites/suites.h"

namespace {

struct ShippedVerbs : plumb::cli::CatalogueVerbs {
    using plumb::cli::CatalogueVerbs::operator();
    int operator()(const plumb::cli::ConvergeOptions& options) const { return plumb::cli::converge(options); }
    int operator()(const plumb::cli::StudyOptions& options) const { return plumb::cli::study(options); }
    int operator()(const plumb::cli::ReferenceOptions& options) const { return plumb::cli::reference(options); }
    int operator()(const plumb::cli::RenderOptions& options) const { return plumb::cli::render(options); }
    int operator()(const plumb::cli::ExplainOptions& options) const { return plumb::cli::explain(options); }
    int operator()(const plumb::cli::CompareOptions& options) const { return plumb::cli::compare(options); }
    int operator()(const plumb::cli::MergeOptions& options) const {
        return options.image.empty() ? plumb::cli::merge(options) : plumb::cli::merge_films(options);
    }
    int operator()(const plumb::cli::CheckOptions& options) const { return plumb::cli::check(options); }
    int operator()(const plumb::cli::IntegrateOptions& options) const { return plumb::cli::integrate(options); }
    int operator()(const plumb::cli::WeightsOptions& options) const { return plumb::cli::weights(options); }
};

}  // namespace

int main(int argc, char** argv) {
    return plumb::cli::reporting_errors(argv, [&] {
        const plumb::Catalogue catalogue = plumb::suites::shipped_catalogue();
        return std::visit(ShippedVerbs{{catalogue, plumb::cli::shipped_lists(catalogue)}},
                          plumb::cli::parse_options(argc, argv, plumb::cli::VerbSet::shipped));
    });
}
