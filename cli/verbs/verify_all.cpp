#include "cli/verbs/sampler/formula_density.h"
#include "cli/verbs/verify.h"

namespace plumb::cli::verbs {

// The verb of a catalogue's program, and besides it formulas as densities of samplers.
Verb verify_all() {
    return {"verify", "Judge claims and their mutants; write a report",
            [](CLI::App& verb) { return add_verify(verb, formula_density); }, reason_of_verify};
}

}  // namespace plumb::cli::verbs
