#pragma once

#include <string>
#include <vector>

#include "verification/check.h"

namespace plumb {

/// The size classes that a claim belongs to.
enum class Sizes { both, quick_only, full_only };

/// A sentence that can be wrong, where it comes from, and how to find out.
struct Claim {
    std::string id = {};  ///< group/subject/property: patterns like `reweighting/*` select by it
    std::string statement = {};
    std::string source = {};  ///< paper and equation, or "ours" with the file that derives it
    Kind kind = Kind::exact;
    Trial trial = {};            ///< the check, the right subject and the wrong ones
    std::string no_mutant = {};  ///< why no mutant is possible; required exactly when there is none
    double weight = 1;           ///< of its share of the false-alarm budget; exact and bounded claims take none
    Sizes sizes = Sizes::both;
};

/// A statement of a source that is wrong, what is right instead, and the claim that shows it.
struct Erratum {
    std::string source, printed, correct, claim;
};

/// The closed list of claims: it is complete before anything runs, because the shares of alpha depend on it.
class Catalogue {
public:
    /// Throws std::logic_error for an id used twice, a missing trial, or neither mutant nor reason.
    void add(Claim claim);
    void add(Erratum erratum) { errata_.push_back(std::move(erratum)); }

    [[nodiscard]] const std::vector<Claim>& claims() const { return claims_; }
    [[nodiscard]] const std::vector<Erratum>& errata() const { return errata_; }

    /// A claim's share of the run's alpha: weighted Bonferroni over the whole size class, whatever is selected.
    [[nodiscard]] double share(const Claim& claim, Size size) const;

private:
    std::vector<Claim> claims_;
    std::vector<Erratum> errata_;
};

bool belongs(const Claim& claim, Size size);
bool takes_alpha(Kind kind);

/// Whether an id matches a shell pattern with * and ?.
bool matches(std::string_view id, std::string_view pattern);

}  // namespace plumb
