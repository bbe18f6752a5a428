#pragma once

#include "verification/claim.h"

namespace plumb {

/// Plumb's program over this catalogue: the verbs verify, list, report and merge, with their options, output and exit
/// codes. Bad input ends in one line on standard error and exit code 2.
int run_program(int argc, char** argv, const Catalogue& catalogue);

/// Yours to define when you link plumb::main, whose main() runs the program over the claims that you add here.
void register_claims(Catalogue& catalogue);

}  // namespace plumb
