// Must not compile: the subjects are checks, so that the mutant would be refuted by one of its own.

#include "verification/check.h"

namespace {

plumb::Verdict holds(const plumb::Run&) {
    return {.outcome = plumb::Outcome::holds};
}
plumb::Verdict refuted(const plumb::Run&) {
    return {.outcome = plumb::Outcome::refuted};
}
plumb::Verdict whatever(const plumb::Check& check, const plumb::Run& run) {
    return check(run);
}

const plumb::Trial trial{whatever, holds, {{"mutant", "It is refuted by another check.", refuted}}};

}  // namespace
