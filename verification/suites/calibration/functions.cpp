// The distributions behind the verdicts against sums of positive terms in multi-precision (MPFR): other formulas than
// the library's, so that an agreement means something. Published tables stand in
// verification/evidence/distributions_test.cpp.

#include "verification/evidence/distributions.h"

#include "analytic/real.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using Functions = formulas::Elementary<Real>;

double relative(double found, const Real& truth) {
    return static_cast<double>(abs(Real(Real(found) / truth - 1)));
}

/// P(|Z| > z).
Real normal_tail(double z) {
    return Functions::erfc(Real(Real(z) / sqrt(Real(2))));
}

/// P(X > x) for k degrees of freedom [Abramowitz & Stegun 1964, 26.4.4 and 26.4.5]: finite sums of positive terms.
Real chi_square_survival(const Real& x, int k) {
    const Real half = x / 2;
    Real term = k % 2 == 0 ? exp(Real(-half)) : Real(exp(Real(-half)) * sqrt(half) * 2 / sqrt(Functions::pi()));
    Real sum = k % 2 == 0 ? Real(0) : Functions::erfc(Real(sqrt(half)));
    for (int j = k % 2; j < k; j += 2) {  // term: e^-h h^(j/2) / Γ(j/2 + 1)
        sum += term;
        term *= half * 2 / (j + 2);
    }
    return sum;
}

/// P(X ≤ x) of the noncentral chi-square: a Poisson mixture of central ones, upwards by f(k + 2) = f(k) − density.
Real noncentral_cdf(double x, int k, double noncentrality) {
    const Real rate = Real(noncentrality) / 2;
    Real weight = exp(Real(-rate)), sum = 0;
    const int terms = static_cast<int>(noncentrality / 2 + 40 * std::sqrt(noncentrality / 2 + 1) + 40);
    Real survival = chi_square_survival(Real(x), k);
    const Real half = Real(x) / 2;
    // e^-h h^(k/2) / Γ(k/2 + 1): what the survival grows by with two more degrees of freedom
    Real growth = exp(Real(-half + Real(k) / 2 * log(half))) / tgamma(Real(Real(k) / 2 + 1));
    for (int j = 0; j < terms; ++j) {
        sum += weight * (1 - survival);
        weight *= rate / (j + 1);
        survival += growth;
        growth *= half / (Real(k) / 2 + j + 1);
    }
    return sum;
}

/// P(X ≥ k) of n trials with probability p.
Real binomial_survival(std::uint64_t k, std::uint64_t n, double p) {
    Real term = pow(Real(1 - Real(p)), static_cast<double>(n)), below = 0;
    const Real odds = Real(p) / (1 - Real(p));
    Real above = 0;
    for (std::uint64_t j = 0; j <= n; ++j) {
        (j < k ? below : above) += term;
        term *= odds * Real(n - j) / Real(j + 1);
    }
    return above;
}

const std::vector<double> tails = {0.3, 0.05, 1e-2, 1e-5, 6.7e-7, 1e-12};

using TwoSidedTail = double (*)(double z);

double one_minus_cdf(double z) {
    return 2 * (1 - 0.5 * std::erfc(-z / std::sqrt(2.0)));
}

Verdict normal_is_right(TwoSidedTail tail) {
    std::vector<BoundedCase> cases;
    for (const double z : {1e-3, 0.5, 1.0, 3.0, 5.0, 8.0, 12.0, 30.0})
        cases.push_back({fmt::format("tail beyond {:g} sigma", z), relative(tail(z), normal_tail(z)), z});
    for (const double p : tails) {
        const double z = normal_upper_quantile(p);
        // An ulp of z moves the tail by z² ulp or so: the quantile can be no better than that.
        cases.push_back({fmt::format("quantile at {:g}", p), relative(p, Real(normal_tail(z) / 2)), z});
    }
    return stable(cases, 1e-12, "normal tail and quantile", "z", "relative");
}

using ChiSquareTail = double (*)(double x, double k);

double chi_square_one_minus_cdf(double x, double k) {
    return 1 - (1 - chi_square_tail(x, k));
}

Verdict chi_square_is_right(ChiSquareTail tail) {
    std::vector<BoundedCase> cases;
    for (const int k : {1, 2, 3, 9, 63, 255, 1023})
        for (const double p : tails) {
            const double x = chi_square_upper_quantile(p, k);
            const Real truth = chi_square_survival(Real(x), k);
            cases.push_back({fmt::format("tail at {:.4g}, k = {}", x, k), relative(tail(x, k), truth), x});
            cases.push_back({fmt::format("quantile at {:g}, k = {}", p, k), relative(p, truth), x});
        }
    cases.push_back({"tail at 400, k = 3", relative(tail(400, 3), chi_square_survival(Real(400), 3)), 400});
    return stable(cases, 1e-11, "chi-square tail and quantile", "x", "relative");
}

using NoncentralBound = double (*)(double x, double k, double beta);

double bound_by_central_quantile(double x, double k, double beta) {
    return std::max(x - chi_square_upper_quantile(1 - beta, k), 0.0);
}

Verdict noncentral_is_right(NoncentralBound bound) {
    std::vector<BoundedCase> cases;
    for (const int k : {1, 3, 15, 99, 255})
        for (const double beta : {1e-2, 1e-4, 1e-7})
            for (const double p : {0.5, 0.05, 1e-5}) {
                const double x = chi_square_upper_quantile(p, k), noncentrality = bound(x, k, beta);
                cases.push_back({fmt::format("x = {:.4g}, k = {}, beta = {:g}", x, k, beta),
                                 relative(beta, noncentral_cdf(x, k, noncentrality)), x});
            }
    return within_bound(cases, 1e-6, "of beta");
}

using ProbabilityInterval = Interval (*)(std::uint64_t successes, std::uint64_t trials, double tail);

Interval wald_interval(std::uint64_t successes, std::uint64_t trials, double tail) {
    const double n = static_cast<double>(trials), p = static_cast<double>(successes) / n;
    const double half = normal_upper_quantile(tail) * std::sqrt(p * (1 - p) / n);
    return {p - half, p + half};
}

Verdict clopper_pearson_is_right(ProbabilityInterval interval) {
    std::vector<BoundedCase> cases;
    for (const auto& [k, n] : {std::pair{1, 1}, {1, 20}, {4, 20}, {19, 20}, {3, 1000}, {500, 1000}, {997, 1000}})
        for (const double tail : {0.05, 1e-4}) {
            const Interval p = interval(k, n, tail);
            const auto name = fmt::format("{} of {} at {:g}", k, n, tail);
            cases.push_back({name + ", low", relative(tail, binomial_survival(k, n, p.low)), 0});
            if (k < n)
                cases.push_back({name + ", high", relative(tail, Real(1 - binomial_survival(k + 1, n, p.high))), 0});
        }
    return within_bound(cases, 1e-10, "of the tail");
}

}  // namespace

void add_calibration_functions(Catalogue& catalogue) {
    const auto add = [&](std::string id, std::string statement, auto check, auto right, std::string mutant,
                         std::string defect, auto wrong) {
        catalogue.add({.id = "calibration/functions/" + id,
                       .statement = std::move(statement),
                       .source = "[Abramowitz & Stegun 1964, 26.4 and 26.5], summed in MPFR",
                       .kind = Kind::bounded,
                       .trial = {check, right, {{std::move(mutant), std::move(defect), wrong}}}});
    };
    add("normal", "The normal tail and quantile are right to 1e-12 from 1e-3 to 30 sigma.", normal_is_right,
        &normal_two_sided_tail, "one-minus-cdf", "the tail as 1 − cdf", &one_minus_cdf);
    add("chi-square", "The chi-square's tail and quantile are right to 1e-11, far tails included.", chi_square_is_right,
        &chi_square_tail, "one-minus-cdf", "the tail as 1 − cdf", &chi_square_one_minus_cdf);
    add("noncentral", "At the upper bound of the noncentrality the probability of so small a value is beta, to 1e-6.",
        noncentral_is_right, &noncentrality_upper_bound, "central-quantile",
        "the distance to the central quantile taken for the bound", &bound_by_central_quantile);
    add("clopper-pearson", "The ends of the Clopper–Pearson interval have the stated binomial tails, to 1e-10.",
        clopper_pearson_is_right, &clopper_pearson, "wald", "the textbook's p ± z sqrt(p (1 − p)/n)", &wald_interval);
}

}  // namespace plumb::suites
