#include "reports/run/merge.h"

#include <CLI/CLI.hpp>

#include "cli/verb.h"
#include "cli/verbs/outputs.h"

namespace plumb::cli::verbs {
namespace {

struct Options : Outputs {
    std::vector<std::string> stores;
};

int merge(const Options& options) {
    check_outputs(options);
    const reports::Results merged = reports::merge_shards({options.stores.begin(), options.stores.end()});
    reports::Store store(options.store, reports::Store::Access::append);
    const std::int64_t run = reports::store_once(store, merged);
    return publish(store.load(run), run, options);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("stores", options->stores, "the stores that the shards were written to")->required();
    add_outputs(verb, *options);
    verb.footer(
        "Exit code: as of plumb verify. Merging twice changes nothing.\n\n"
        "Example: plumb merge shard-*.db --store out/results.db");
    return [options](const Catalogue&) { return merge(*options); };
}

}  // namespace

Verb merge() {
    return {"merge", "Join the shards of a run into the run that they make up", add};
}

}  // namespace plumb::cli::verbs
