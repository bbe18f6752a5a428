// A program of your own: link plumb::main, register claims, and have `own_claims verify`, `list` and `report`.

#include "cli/program.h"
#include "verification/evidence/mean.h"

namespace {

// Four times the fraction of a quarter disk that a random point of the square hits: the mean is pi.
double four_quarters(plumb::RandomStream& random) {
    const double x = random.uniform(), y = random.uniform();
    return x * x + y * y < 1 ? 4 : 0;
}

// The same with one random number for both coordinates: the mean is 4 / sqrt(2).
double on_the_diagonal(plumb::RandomStream& random) {
    const double x = random.uniform();
    return x * x + x * x < 1 ? 4 : 0;
}

plumb::Verdict has_mean_pi(const plumb::Draw& draw, const plumb::Run& run) {
    return plumb::mean_is(draw, {.reference = 3.14159265358979323846, .delta = 0.02, .bounds = {0, 4}}, run);
}

}  // namespace

void plumb::register_claims(plumb::Catalogue& catalogue) {
    catalogue.add({.id = "pi/quarter-disk/unbiased",
                   .statement = "Four times the hits of a quarter disk have the mean pi.",
                   .source = "Buffon's heirs",
                   .kind = plumb::Kind::mean,
                   .trial = {has_mean_pi,
                             four_quarters,
                             {{"one-number-for-two", "x and y are the same random number", on_the_diagonal}}}});
}
