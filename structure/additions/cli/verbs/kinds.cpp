#include <CLI/CLI.hpp>
#include <map>

#include "cli/verb.h"
#include "verification/claim.h"

namespace plumb::cli::verbs {
namespace {

int kinds(const Catalogue& catalogue) {
    std::map<std::string, int> counts;
    for (const Claim& claim : catalogue.claims()) ++counts[to_string(claim.kind)];
    for (const auto& [kind, count] : counts) fmt::print("{:12} {}\n", kind, count);
    return 0;
}

Action add(CLI::App& verb) {
    verb.footer("Example: plumb kinds");
    return kinds;
}

}  // namespace

Verb kinds() {
    return {"kinds", "Count the claims of each kind of evidence", add};
}

}  // namespace plumb::cli::verbs
