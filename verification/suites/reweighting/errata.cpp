// What the thesis states and our claims refute.

#include "verification/claim.h"

namespace plumb::suites {

void add_reweighting_errata(Catalogue& catalogue) {
    catalogue.add(Erratum{
        "[thesis, section 4.4.2] and appendix A.2",
        "Weights of periodically augmented samples give a biased estimate: E = ∫ [1 + (1−x)^{N−2} ((1−x)(N+x−1) − "
        "N(N+x−2))/2] f(x) dx (the printed integrand, simplified).",
        "On the circle E|V| = 1/N wherever the sample lies, so the estimate is unbiased for every N. The printed "
        "integrand "
        "cannot be that of weights that sum to 1: its integral is not 1 (5/6 at N = 2) and it is not symmetric in x → "
        "1−x. "
        "The powers of x, from the last sample's cell, cancel in it as they must; those of 1−x, from the first one's, "
        "do not.",
        "reweighting/torus-cells-1d/exact"});
    catalogue.add(
        Erratum{"[thesis, section 4.5.1]",
                "The unbiased estimator (eq. 4.8) asymptotically achieves the rate of Yakowitz et al., O(N^{-4/D}).",
                "Where f(0) or f(1) is not 0 its MSE falls like N^-2: the boundary cell, of length O(1/N), is off by a "
                "random factor "
                "of order 1. The line through f(0) and f(1) as a control variate restores N^-4 without bias.",
                "reweighting/reweighted/rate"});
    catalogue.add(
        Erratum{"thesis, sections 4.4.1, 4.4.3 and 4.5",
                "One function g serves the unbiased estimator for i.i.d. uniform and for stratified sampling.",
                "For one jittered sample in each of N strata the expected cell is g_s: 1 inside, (Nx + 3/2)/2 in the "
                "first stratum, "
                "mirrored in the last; with the g of i.i.d. samples e^x is overestimated by 3.8 % at N = 4.",
                "reweighting/stratified-reweighted/unbiased"});
    catalogue.add(Erratum{"[thesis, section 4.4.4]",
                          "Reweighting the strata of a piecewise-constant density, each by itself, introduces no bias.",
                          "Only with counts ≥ 1 fixed beforehand: i.i.d. samples of the density leave strata empty and "
                          "lose their integral, "
                          "18.5 % of it for 10 equal strata and N = 16.",
                          "reweighting/piecewise-strata/unbiased"});
}

}  // namespace plumb::suites
