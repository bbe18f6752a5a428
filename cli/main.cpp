#include "cli/verbs.h"
#include "verification/suites/suites.h"

namespace {

struct ShippedVerbs : plumb::CatalogueVerbs {
    using plumb::CatalogueVerbs::operator();
    int operator()(const plumb::ConvergeOptions& options) const { return plumb::converge(options); }
    int operator()(const plumb::StudyOptions& options) const { return plumb::study(options); }
    int operator()(const plumb::ReferenceOptions& options) const { return plumb::reference(options); }
    int operator()(const plumb::RenderOptions& options) const { return plumb::render(options); }
    int operator()(const plumb::ExplainOptions& options) const { return plumb::explain(options); }
    int operator()(const plumb::CompareOptions& options) const { return plumb::compare(options); }
    int operator()(const plumb::MergeOptions& options) const {
        return options.image.empty() ? plumb::merge(options) : plumb::merge_films(options);
    }
    int operator()(const plumb::CheckOptions& options) const { return plumb::check(options); }
    int operator()(const plumb::IntegrateOptions& options) const { return plumb::integrate(options); }
    int operator()(const plumb::WeightsOptions& options) const { return plumb::weights(options); }
};

}  // namespace

int main(int argc, char** argv) {
    return plumb::reporting_errors(argv, [&] {
        const plumb::Catalogue catalogue = plumb::shipped_catalogue();
        return std::visit(ShippedVerbs{{catalogue, plumb::shipped_lists(catalogue)}},
                          plumb::parse_options(argc, argv, plumb::VerbSet::shipped));
    });
}
