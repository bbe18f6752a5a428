// Stripes against the function that they stand for.

#include <cmath>
#include <functional>
#include <numbers>

#include "scenes/textures/texture.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using Lookup = std::function<double(double u, double v)>;

double stripes(double u, double v) {
    static const TextureLookup lookup(
        {.kind = description::Stripes{Spectrum::grey(1), Spectrum::grey(0)}, .to_uv = {}, .place = {}});
    return lookup.at(u, v)[0];
}

Verdict is_striped(const Lookup& lookup, const Run& run) {
    std::uint64_t wrong = 0, points = 0;
    RandomStream random = run.random(0);
    for (; points < 4096; ++points) {
        const double u = 8 * random.uniform() - 4, v = 8 * random.uniform() - 4;
        wrong += lookup(u, v) != (std::sin(2 * std::numbers::pi * u) > 0 ? 1 : 0);
    }
    return exactly(wrong == 0, points, fmt::format("{} of {} points have the other colour", wrong, points));
}

}  // namespace

void add_surfaces_stripes(Catalogue& catalogue) {
    catalogue.add({.id = "texture/stripes/lookup",
                   .statement = "Stripes have their first colour where sin 2πu is positive.",
                   .source = "ours, scenes/textures/stripes.h",
                   .kind = Kind::exact,
                   .trial = {is_striped,
                             stripes,
                             {{"across", "stripes run along u", [](double u, double v) { return stripes(v, u); }},
                              {"wide", "the period is 2", [](double u, double v) { return stripes(u / 2, v); }}}}});
}

}  // namespace plumb::suites
