// The two ways in which a lantern gives light, as rays of its own and as what arrives.

#include <cmath>
#include <functional>

#include "scenes/emitters/lantern.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

const Lantern lantern{{1, 2, 3}, Frame(normalize({1, -2, 2})), Spectrum::grey(5)};

/// Intensity along a direction, by what arrives at a point there.
using Arriving = std::function<double(Vec3 direction)>;

double arriving(Vec3 direction) {
    return 4 * luminance(lantern.sample(lantern.position + 2 * direction, {})->radiance);
}

// A ray's flux is intensity over density.
Verdict agree(const Arriving& intensity, const Run& run) {
    std::vector<BoundedCase> cases;
    RandomStream random = run.random(0);
    for (int i = 0; i < 1000; ++i) {
        const double v = random.uniform();
        const EmittedRay ray = lantern.sample_ray({}, {}, {v, random.uniform()});
        const double sent = luminance(ray.weight) * ray.pdf.direction, found = intensity(ray.direction);
        cases.push_back({fmt::format("{} sent, {} arrive", sent, found), std::abs(found - sent)});
    }
    return within_bound(cases, 1e-9, "of at most 5");
}

}  // namespace

void add_lights_lantern(Catalogue& catalogue) {
    catalogue.add({.id = "light/lantern/intensity",
                   .statement = "A lantern sends as much along a direction as arrives there.",
                   .source = "ours, scenes/emitters/lantern.h",
                   .kind = Kind::bounded,
                   .trial = {agree,
                             arriving,
                             {{"no-cosine", "what arrives is the same to every side", [](Vec3) { return 5.0; }},
                              {"behind", "the cosine is with the way back",
                               [](Vec3 direction) { return arriving(-direction); }}}}});
}

}  // namespace plumb::suites
