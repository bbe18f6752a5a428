#include "reports/run/merge.h"

#include "cli/commands.h"
#include "cli/outputs.h"
#include "core/error.h"

namespace plumb::cli {

int merge(const MergeOptions& options) {
    check_outputs(options);
    const reports::Results merged = reports::merge_shards({options.stores.begin(), options.stores.end()});
    reports::Store store(options.store, reports::Store::Access::append);
    const std::int64_t run = reports::store_once(store, merged);
    return publish(store.load(run), run, options);
}

}  // namespace plumb::cli
