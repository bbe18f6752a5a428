// plumb::main: a program for whoever registers claims, as benchmark_main is for benchmarks.

#include "cli/command_line.h"
#include "cli/program.h"

int main(int argc, char** argv) {
    plumb::Catalogue catalogue;
    const int failure = plumb::cli::reporting_errors(argv, [&] {
        plumb::register_claims(catalogue);
        return 0;
    });
    return failure ? failure : plumb::run_program(argc, argv, catalogue);
}
