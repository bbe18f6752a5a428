#include "cli/program.h"

#include "cli/verbs.h"

namespace plumb {

int run_program(int argc, char** argv, const Catalogue& catalogue) {
    return cli::reporting_errors(argv, [&] {
        return std::visit(cli::CatalogueVerbs{catalogue, cli::catalogue_lists(catalogue)},
                          cli::parse_options(argc, argv, cli::VerbSet::of_a_catalogue));
    });
}

}  // namespace plumb
