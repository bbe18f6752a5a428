#include "analytic/integrand.h"

#include <numbers>

#include "analytic/quadrature.h"
#include "analytic/rational.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

// ---- the answers against two quadratures ----

template <int D>
Verdict agrees_with(Quadrature method, std::span<const Integrand<D>> stated) {
    std::vector<BoundedCase> cases;
    for (const QuadratureError& error : quadrature_errors(stated, method)) {
        cases.push_back({error.id + ", integral", error.integral});
        cases.push_back({error.id + ", mean square", error.second_moment});
    }
    return within_bound(cases, D == 1 ? 1e-50 : 1e-15, "of the root mean square (or mean square)");
}

/// Integrands with their stated answers; a wrong one is a single integrand with an answer misstated.
template <int D>
using Stated = std::vector<Integrand<D>>;

template <int D>
Integrand<D> with_integral(std::string_view id, double integral) {
    Integrand<D> wrong = find_integrand<D>(id);
    wrong.integral = fmt::format("{:.17g}", integral);
    return wrong;
}

/// 3 units of the given decimal place away from the integral.
template <int D>
Integrand<D> with_digit_changed(std::string_view id, std::size_t place) {
    Integrand<D> wrong = find_integrand<D>(id);
    char& digit = wrong.integral[wrong.integral.find('.') + place];
    digit = static_cast<char>(digit < '5' ? digit + 3 : digit - 3);
    return wrong;
}

std::vector<Wrong<Stated<1>>> misstated_1d() {
    using std::numbers::pi;
    const double a = 6.515625, u = 0.703125;  // of genz/product-peak-1
    return {{"digit-50", "the integral of e^x with its 50th decimal 3 off", {with_digit_changed<1>("exp", 50)}},
            {"humps-alike",
             "the thesis function with its last hump as high as the one before",
             {with_integral<1>("thesis-1d", 17 / 8. + 12 / (10 * pi))}},
            {"product-peak-parenthesis",
             "the factor a multiplies only the first arctangent",
             {with_integral<1>("genz/product-peak-1", a * std::atan(a * (1 - u)) + std::atan(a * u))}}};
}

std::vector<Wrong<Stated<2>>> misstated_2d() {
    using std::numbers::pi;
    const double a = 3.65625, u = 0.703125, b = 3.59375, v = 0.546875;  // of genz/product-peak-2d-1
    return {{"digit-15",
             "the integral of Keister's function with its 15th decimal 3 off",
             {with_digit_changed<2>("keister-2d", 15)}},
            {"whole-disk",
             "a disk that leaves the square with the area of the whole disk",
             {with_integral<2>("disk-cut", pi * 4 / 25)}},
            {"product-peak-parenthesis",
             "the factors a multiply only the first arctangents",
             {with_integral<2>("genz/product-peak-2d-1", (a * std::atan(a * (1 - u)) + std::atan(a * u)) *
                                                             (b * std::atan(b * (1 - v)) + std::atan(b * v)))}}};
}

template <int D>
void add_quadrature_claim(Catalogue& catalogue, Quadrature method, std::string name,
                          std::vector<Wrong<Stated<D>>> misstated) {
    catalogue.add({
        .id = fmt::format("integrand/{}d/{}", D, name),
        .statement = fmt::format("Integral and variance of every {}D integrand are those of {} quadrature, within {}.",
                                 D, to_string(method), D == 1 ? "1e-50" : "1e-15"),
        .source = "ours, analytic/quadrature.h; each integrand names its own source",
        .kind = Kind::bounded,
        .trial = {[method](const Stated<D>& stated) { return agrees_with<D>(method, stated); }, integrands<D>(),
                  std::move(misstated)},
    });
}

// ---- the pinned decimals of polynomials against rational arithmetic ----

/// A fraction as a decimal of 55 places, rounded half up.
std::string decimal(const Rational& value) {
    using boost::multiprecision::cpp_int;
    const cpp_int unit = boost::multiprecision::pow(cpp_int(10), 55);
    const Rational shifted = value * unit + Rational(1, 2);
    const cpp_int scaled = numerator(shifted) / denominator(shifted);
    return fmt::format("{}.{:0>55}", cpp_int(scaled / unit).str(), cpp_int(scaled % unit).str());
}

using Variance = Rational (*)(const RationalPolynomial&);

Rational variance_of(const RationalPolynomial& p) {
    const Rational mean = integral(p, 0, 1);
    return integral(p * p, 0, 1) - mean * mean;
}

Verdict polynomials_are_exact(Variance variance) {
    const RationalPolynomial x = identity_polynomial();
    const std::vector<std::pair<std::string, RationalPolynomial>> polynomials{
        {"constant", 1},
        {"linear", x},
        {"square", pow(x, 2)},
        {"cubic", pow(x, 3)},
        {"quintic", pow(x, 5)},
        {"parabola", 4 * x * (1 - x)},
        {"cancellation", 1000000 * (5 * pow(x, 4) - 1)}};
    for (const auto& [id, p] : polynomials) {
        const Integrand<1>& stated = find_integrand<1>(id);
        const std::string mean = decimal(integral(p, 0, 1)), spread = decimal(variance(p));
        if (stated.integral != mean || stated.variance != spread)
            return exactly(false, polynomials.size(),
                           fmt::format("{} = {}: integral {} and variance {}, stated {} and {}", id, to_string(p), mean,
                                       spread, stated.integral, stated.variance));
    }
    return exactly(true, polynomials.size(),
                   "all 55 decimals of both answers of each polynomial are those of the fractions");
}

// ---- the values in double against multi-precision ----

/// Powers of two from either end, and random numbers.
std::vector<double> hard_coordinates(const Run& run) {
    std::vector<double> coordinates;
    for (int k = 1; k <= 52; ++k) coordinates.insert(coordinates.end(), {std::ldexp(1, -k), 1 - std::ldexp(1, -k)});
    for (std::uint64_t i = 0; i < 100; ++i) coordinates.push_back(run.random(i).uniform());
    return coordinates;
}

/// The largest difference from the correctly rounded value over the integrand's bound (where it has none: the value).
template <int D>
BoundedCase worst_rounding(const Integrand<D>& f, const std::vector<double>& coordinates) {
    BoundedCase worst{f.id, 0};
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        Point<D> x{coordinates[i]};
        if (D == 2) x[D - 1] = coordinates[(7 * i + 3) % coordinates.size()];
        const double truth = correctly_rounded<D>(f.id, x);
        const double scale =
            f.bounds.bounded() ? std::max(std::abs(f.bounds.low), std::abs(f.bounds.high)) : std::abs(truth);
        const double error = std::abs(f(x) - truth) / scale;
        if (!(error <= worst.error)) worst = {fmt::format("{} at {}", f.id, fmt::join(x, ", ")), error};
    }
    return worst;
}

struct Evaluated {
    std::vector<Integrand<1>> in_1d;
    std::vector<Integrand<2>> in_2d;
};

Verdict rounds_well(const Evaluated& integrands, const Run& run) {
    const std::vector<double> coordinates = hard_coordinates(run);
    std::vector<BoundedCase> cases;
    for (const auto& f : integrands.in_1d) cases.push_back(worst_rounding(f, coordinates));
    for (const auto& f : integrands.in_2d) cases.push_back(worst_rounding(f, coordinates));
    return within_bound(cases, 1e-12, "of the largest value");
}

Integrand<2> with_short_pi() {
    Integrand<2> wrong = find_integrand<2>("aliasing-2d");
    wrong.value = [](const Point<2>& p) {
        const double short_pi = 3.141592653590;
        return 1 + std::cos(32 * short_pi * p[0]) * std::cos(32 * short_pi * p[1]);
    };
    return wrong;
}

// ---- plain Monte Carlo ----

template <int D>
using Values = std::function<double(const Point<D>&)>;

/// The verdict on whether the mean of `values` at uniform points is the stated integral of f; delta is relative to √E
/// f².
template <int D>
Verdict plain_mean(const Integrand<D>& f, const Values<D>& values, double relative_delta, const Run& run) {
    const auto draw = [&values](RandomStream& random) {
        Point<D> x;
        for (double& axis : x) axis = random.uniform();
        return values(x);
    };
    const double delta = relative_delta * f.root_mean_square();
    const double ratio = std::sqrt(f.variance_value()) / delta;
    return mean_is(draw,
                   {.reference = f.integral_value(),
                    .delta = delta,
                    .bounds = f.bounds,
                    .cap = static_cast<std::uint64_t>(200 * ratio * ratio) + 100000},
                   run);
}

/// A claim on the mean of an integrand, with a mutant whose values are wrong by 2 to 4 delta in the mean.
template <int D>
void add_mean_claim(Catalogue& catalogue, std::string_view id, double relative_delta, std::string mutant,
                    std::string defect, Values<D> wrong) {
    const Integrand<D>& f = find_integrand<D>(id);
    catalogue.add({
        .id = fmt::format("integrand/{}/mean", id),
        .statement =
            fmt::format("The mean of {} at uniform points is its stated integral, {:.6g}.", id, f.integral_value()),
        .source = f.source,
        .kind = Kind::mean,
        .trial = {[&f, relative_delta](const Values<D>& values, const Run& run) {
                      return plain_mean<D>(f, values, relative_delta, run);
                  },
                  f.value,
                  {{std::move(mutant), std::move(defect), wrong}}},
    });
}

void add_mean_claims(Catalogue& catalogue) {
    add_mean_claim<1>(catalogue, "exp", 0.01, "taylor-2", "e^x by its Taylor polynomial of degree 2 (-2.9 delta)",
                      [](const Point<1>& x) { return 1 + x[0] + x[0] * x[0] / 2; });
    add_mean_claim<1>(catalogue, "thesis-1d", 0.01, "humps-alike",
                      "the last hump as high as the one before (-4.0 delta)",
                      [](const Point<1>& x) { return find_integrand<1>("thesis-1d")(x) * (x[0] > 0.9 ? 0.5 : 1); });
    add_mean_claim<1>(catalogue, "cancellation", 0.01, "coefficient", "4.84 in place of the coefficient 5 (-2.4 delta)",
                      [](const Point<1>& x) { return 1e6 * (4.84 * std::pow(x[0], 4) - 1); });
    add_mean_claim<2>(catalogue, "disk-cut", 0.015, "wrapped",
                      "the disk's part beyond x = 1 comes back at 0 (3.5 delta)", [](const Point<2>& p) {
                          const double x = std::remainder(p[0] - 0.7, 1), y = p[1] - 0.5;
                          return x * x + y * y < 0.16 ? 1. : 0.;
                      });
    add_mean_claim<2>(
        catalogue, "test-image", 0.015, "no-sun", "the sky without the sun (-3.0 delta)",
        [](const Point<2>& p) { return p[1] >= 0.5 ? 0.25 + p[1] / 2 : find_integrand<2>("test-image")(p); });
    add_mean_claim<2>(catalogue, "keister-2d", 0.01, "no-tails",
                      "the normal quantile cut at two deviations (3.1 delta)", [](const Point<2>& p) {
                          const auto cut = [](double u) { return std::clamp(u, 0.022750131948179, 0.977249868051821); };
                          return find_integrand<2>("keister-2d")({cut(p[0]), cut(p[1])});
                      });
}

/// Plain Monte Carlo on an integrand of infinite variance: the samples cannot say how far they are off.
Verdict ends_undecided(const Integrand<1>& f, const Run& run) {
    const auto draw = [&f](RandomStream& random) { return f({random.uniform()}); };
    const MeanClaim claim{.reference = f.integral_value(),
                          .delta = 0.02 * f.integral_value(),
                          .bounds = f.bounds,
                          .cap = run.pick<std::uint64_t>(1 << 17, 1 << 20)};
    return outcome_is(mean_is(draw, claim, run), Outcome::undecided);
}

void add_undecided_claim(Catalogue& catalogue, std::string_view id) {
    const Integrand<1>& f = find_integrand<1>(id);
    catalogue.add({
        .id = fmt::format("integrand/{}/undecided", id),
        .statement = fmt::format("{} has a mean but no variance: plain Monte Carlo cannot decide it.", f.formula),
        .source = "ours, analytic/formulas/singular.h",
        .kind = Kind::mean,
        .trial = {ends_undecided,
                  f,
                  {{"finite-variance", "an integrand with a variance, which plain Monte Carlo does decide",
                    find_integrand<1>("linear")}}},
    });
}

}  // namespace

void add_integrands_integrands(Catalogue& catalogue) {
    for (const auto& [method, name] :
         {std::pair{Quadrature::gauss_legendre, "gauss-legendre"}, std::pair{Quadrature::tanh_sinh, "tanh-sinh"}}) {
        add_quadrature_claim<1>(catalogue, method, name, misstated_1d());
        add_quadrature_claim<2>(catalogue, method, name, misstated_2d());
    }
    catalogue.add({
        .id = "integrand/polynomials/exact",
        .statement =
            "Integral and variance of the 1D polynomials are, to 55 decimals, the fractions of exact arithmetic.",
        .source = "ours, analytic/rational.h",
        .kind = Kind::exact,
        .trial = {polynomials_are_exact,
                  variance_of,
                  {{"mean-square", "the mean square taken for the variance",
                    [](const RationalPolynomial& p) { return integral(p * p, 0, 1); }}}},
    });
    catalogue.add({
        .id = "integrand/values/rounding",
        .statement = "Every integrand in double is within 1e-12 of its largest value of the multi-precision formula.",
        .source = "ours, analytic/formulas",
        .kind = Kind::bounded,
        .trial = {rounds_well,
                  {integrands_1d(), integrands_2d()},
                  {{"short-pi",
                    "pi to 12 decimals in aliasing-2d (about 3e-12 of its largest value)",
                    {{}, {with_short_pi()}}}}},
    });

    add_mean_claims(catalogue);
    add_undecided_claim(catalogue, "inverse-sqrt");
    add_undecided_claim(catalogue, "inverse-power-0.9");
}

}  // namespace plumb::suites
