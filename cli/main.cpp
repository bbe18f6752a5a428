#include "cli/command_line.h"
#include "verification/suites/suites.h"

int main(int argc, char** argv) {
    return plumb::cli::reporting_errors(argv, [&] {
        return plumb::cli::run_verb(argc, argv, plumb::cli::shipped_verbs(), plumb::suites::shipped_catalogue());
    });
}
