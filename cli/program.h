#pragma once

#include "verification/claim.h"

namespace plumb {

/// Plumb's program over this catalogue: the verbs verify, list, report and merge, with their options, output and exit
/// codes. Bad input ends in one line on standard error and exit code 2.
int run_program(int argc, char** argv, const Catalogue& catalogue);

/// Adds claims to the program of plumb::main. Whoever links plumb::main defines this function.
void register_claims(Catalogue& catalogue);

}  // namespace plumb
