// What a pane without thickness reflects, against the sum over all reflections within it, in 80 digits.

#include "analytic/real.h"
#include "scenes/bsdfs/fresnel.h"
#include "scenes/bsdfs/thindielectric.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using Reflectance = std::function<double(double cosine, double eta)>;

// An interface of index η under cosine c reflects R = (r_s² + r_p²)/2 [Born & Wolf 1999, 1.5.2], from either side. Of
// what enters, (1 − R)² R^(2n+1) leaves on the near side after 2n + 1 reflections within.
Real sum_over_orders(double cosine, double index) {
    const Real c = cosine, eta = index, far = 1 - (1 - c * c) / (eta * eta);
    if (!(far > 0)) return 1;
    const Real t = sqrt(far), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    const Real once = (s * s + p * p) / 2;
    if (once == 0 || once == 1) return once;  // to 80 digits
    // The geometric series by its limit: at grazing incidence its terms are too many to be summed.
    return once + (1 - once) * (1 - once) * once / (1 - once * once);
}

Verdict is_sum_over_orders(const Reflectance& found) {
    std::vector<BoundedCase> cases;
    for (const double c : {0x1p-1000, 1e-100, 1e-12, 1e-4, 0.1, 0.5, 0.745, 0.9, 1 - 1e-12, 1.0})
        for (const double eta : {1 + 0x1p-52, 1 + 1e-12, 1 + 1e-6, 1.0003, 1.33, 1.5, 2.4, 4.0, 1e3, 1 / 1.33, 1 / 2.4})
            cases.push_back({fmt::format("cosine {:.17g}, eta {:.17g}", c, eta),
                             ulp_error(found(c, eta), static_cast<double>(sum_over_orders(c, eta))), c});
    return stable(cases, 28, "pane_reflectance", "cosine of incidence");
}

}  // namespace

void add_surfaces_panes(Catalogue& catalogue) {
    catalogue.add({.id = "bsdf/thindielectric/orders",
                   .statement = "What a pane reflects is the sum over all reflections within it, to 28 ulp.",
                   .source = "[Born & Wolf 1999, 1.5.2]; ours, scenes/bsdfs/thindielectric.cpp",
                   .kind = Kind::bounded,
                   .trial = {is_sum_over_orders,
                             pane_reflectance,
                             {{"one-interface", "What one interface reflects.",
                               [](double c, double eta) { return fresnel_dielectric(c, eta).reflectance; }},
                              {"two-orders", "Nothing is reflected within more than once.",
                               [](double c, double eta) {
                                   const double once = fresnel_dielectric(c, eta).reflectance;
                                   return once + (1 - once) * (1 - once) * once;
                               }},
                              {"twice", "The reflectances of both interfaces, added.", [](double c, double eta) {
                                   return std::min(1.0, 2 * fresnel_dielectric(c, eta).reflectance);
                               }}}}});
}

}  // namespace plumb::suites
