#include "verification/claim.h"

#include <stdexcept>

namespace plumb {

bool belongs(const Claim& claim, Size size) {
    return claim.sizes == Sizes::both || (claim.sizes == Sizes::quick_only) == (size == Size::quick);
}

bool takes_alpha(Kind kind) {
    return kind != Kind::exact && kind != Kind::bounded && kind != Kind::cost;
}

void Catalogue::add(Claim claim) {
    const auto fail = [&](std::string_view what) {
        throw std::logic_error(fmt::format("claim '{}': {}", claim.id, what));
    };
    if (claim.id.empty() || claim.statement.empty() || claim.source.empty())
        fail("a claim needs an id, a statement and a source");
    if (!claim.trial) fail("a claim needs a trial");
    const std::vector<Mutant>& mutants = claim.trial.mutants();
    if (mutants.empty() == claim.no_mutant.empty())
        fail("a claim has mutants, or says why none is possible, and not both");
    for (const Claim& other : claims_)
        if (other.id == claim.id) fail("this id is taken");
    for (std::size_t i = 0; i < mutants.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (mutants[i].id == mutants[j].id) fail("two mutants of the id '" + mutants[i].id + "'");
    claims_.push_back(std::move(claim));
}

double Catalogue::share(const Claim& claim, Size size) const {
    if (!takes_alpha(claim.kind)) return 0;
    double total = 0;
    for (const Claim& other : claims_)
        if (belongs(other, size) && takes_alpha(other.kind)) total += other.weight;
    return claim.weight / total;
}

bool matches(std::string_view id, std::string_view pattern) {
    if (pattern.empty()) return id.empty();
    if (pattern.front() == '*')
        return matches(id, pattern.substr(1)) || (!id.empty() && matches(id.substr(1), pattern));
    return !id.empty() && (pattern.front() == '?' || pattern.front() == id.front()) &&
           matches(id.substr(1), pattern.substr(1));
}

}  // namespace plumb
