#include "analytic/any_integrand.h"

#include <algorithm>
#include <vector>

#include "core/named.h"

namespace plumb {
namespace {

struct Entry {
    std::string_view id;
    AnyIntegrand integrand;
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = [] {
        std::vector<Entry> list;
        for (const Integrand<1>& f : integrands<1>()) list.push_back({f.id, &f});
        for (const Integrand<2>& f : integrands<2>()) list.push_back({f.id, &f});
        return list;
    }();
    return all;
}

}  // namespace

AnyIntegrand find_any_integrand(std::string_view id) {
    return find_named(entries(), id, "integrand").integrand;
}

std::optional<AnyIntegrand> known_integrand(std::string_view id) {
    const auto found = std::ranges::find(entries(), id, &Entry::id);
    return found == entries().end() ? std::nullopt : std::optional(found->integrand);
}

}  // namespace plumb
