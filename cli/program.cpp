#include "cli/program.h"

#include "cli/command_line.h"

namespace plumb {

int run_program(int argc, char** argv, const Catalogue& catalogue) {
    return cli::reporting_errors(argv, [&] { return cli::run_verb(argc, argv, cli::catalogue_verbs(), catalogue); });
}

}  // namespace plumb
