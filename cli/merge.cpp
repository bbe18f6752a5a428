#include "reports/run/merge.h"

#include "cli/commands.h"
#include "cli/outputs.h"
#include "core/error.h"

namespace plumb {

int merge(const MergeOptions& options) {
    check_outputs(options);
    const Results merged = merge_shards({options.stores.begin(), options.stores.end()});
    Store store(options.store, Store::Access::append);
    const std::int64_t run = store_once(store, merged);
    return publish(store.load(run), run, options);
}

}  // namespace plumb
