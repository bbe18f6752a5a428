#include "cli/program.h"

#include "cli/verbs.h"

namespace plumb {

int run_program(int argc, char** argv, const Catalogue& catalogue) {
    return reporting_errors(argv, [&] {
        return std::visit(CatalogueVerbs{catalogue, catalogue_lists(catalogue)},
                          parse_options(argc, argv, VerbSet::of_a_catalogue));
    });
}

}  // namespace plumb
