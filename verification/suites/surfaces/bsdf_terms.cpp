// Fresnel's and the microfacets' terms where doubles could fail them, against the textbook's formulas in 80 digits.

#include <numbers>

#include "analytic/real.h"
#include "scenes/bsdfs/fresnel.h"
#include "scenes/bsdfs/microfacet.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

template <class R>
struct TextbookFresnel {
    R reflectance, transmittance;
};

// r_s = (c − η c_t)/(c + η c_t), r_p = (η c − c_t)/(η c + c_t), c_t² = 1 − (1 − c²)/η² [Born & Wolf 1999, 1.5.2].
template <class R>
TextbookFresnel<R> textbook_dielectric(const R& c, const R& eta) {
    const R far = 1 - (1 - c * c) / (eta * eta);
    if (!(far > 0)) return {R(1), R(0)};
    const R t = sqrt(far), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    const R reflectance = (s * s + p * p) / 2;
    return {reflectance, R(1 - reflectance)};
}

// R_s and R_p by the squared moduli of [Born & Wolf 1999, 14.2]: a + ib the root of (η + ik)² − sin².
template <class R>
R textbook_conductor(const R& c, const R& eta, const R& k) {
    const R s2 = 1 - c * c, re = eta * eta - k * k - s2, modulus = sqrt(re * re + 4 * eta * eta * k * k);
    const R a = sqrt((modulus + re) / 2), b2 = (modulus - re) / 2;
    const R s = ((c - a) * (c - a) + b2) / ((c + a) * (c + a) + b2);
    const R p = s * ((a * c - s2) * (a * c - s2) + b2 * c * c) / ((a * c + s2) * (a * c + s2) + b2 * c * c);
    return (s + p) / 2;
}

struct Pair {
    double cosine, eta;
};

// Just off the critical angle of eta < 1, by so many steps of the last place.
double near_critical(double eta, int steps) {
    double c = std::sqrt((1 - eta) * (1 + eta));
    for (int i = 0; i < std::abs(steps); ++i) c = std::nextafter(c, steps > 0 ? 2 : -1);
    return c;
}

std::vector<Pair> dielectric_corners() {
    std::vector<Pair> pairs;
    for (const double c : {0x1p-1000, 1e-100, 1e-12, 1e-4, 0.1, 0.5, 0.745, 0.9, 1 - 1e-12, 1.0})
        for (const double eta : {1 + 0x1p-52, 1 - 0x1p-53, 1 + 1e-12, 1 - 1e-12, 1 + 1e-6, 1.0003, 1.33, 1.5, 2.4, 4.0,
                                 1e3, 1 / 1.33, 1 / 1.5, 1 / 2.4})
            pairs.push_back({c, eta});
    for (const double eta : {1 / 1.0003, 1 / 1.33, 1 / 1.5, 1 / 2.4})
        for (const int steps : {-1, 0, 1, 2, 100}) pairs.push_back({near_critical(eta, steps), eta});
    return pairs;
}

using Dielectric2 = std::function<double(double cosine, double eta)>;

Verdict dielectric_is(const Dielectric2& found) {
    std::vector<BoundedCase> cases;
    for (const auto& [c, eta] : dielectric_corners()) {
        const auto truth = textbook_dielectric<Real>(c, eta);
        cases.push_back({fmt::format("cosine {:.17g}, eta {:.17g}", c, eta),
                         ulp_error(found(c, eta), static_cast<double>(truth.reflectance)), c});
    }
    return stable(cases, 24, "fresnel_dielectric", "cosine of incidence");
}

using Conductor3 = std::function<double(double cosine, double eta, double k)>;

Verdict conductor_is(const Conductor3& found) {
    std::vector<BoundedCase> cases;
    for (const double c : {1e-100, 1e-12, 1e-4, 0.1, 0.5, 0.9, 1 - 1e-12, 1.0})
        for (const auto& [eta, k] : std::vector<std::pair<double, double>>{{0.2, 3},
                                                                           {1.5, 1e-3},
                                                                           {1.5, 7},
                                                                           {1, 1e-6},
                                                                           {1 + 1e-9, 1e-9},
                                                                           {1.5, 1e-12},
                                                                           {0, 1},
                                                                           {1e-3, 40},
                                                                           {1e4, 1e4}})
            cases.push_back({fmt::format("cosine {:.17g}, index {} + {}i", c, eta, k),
                             ulp_error(found(c, eta, k), static_cast<double>(textbook_conductor<Real>(c, eta, k))), c});
    return stable(cases, 24, "fresnel_conductor", "cosine of incidence");
}

Verdict mean_is_integral(const std::function<double(double)>& found) {
    std::vector<BoundedCase> cases;
    for (const double eta : {1.0003, 1.1, 1.33, 1.5, 2.4, 1 / 1.33, 1 / 1.5}) {
        // 2 ∫ F c dc with c = x², which tames the steep rise at grazing; from inside, all beyond the critical angle
        // is reflected and c² = c_crit² + y⁴ (1 − c_crit²) tames the root there.
        constexpr int n = 4000;
        const double critical = eta < 1 ? 1 - eta * eta : 0;
        Real sum = critical;
        for (int i = 0; i < n; ++i)
            for (const double gauss : {-0.57735026918962576, 0.57735026918962576}) {
                const double y = (i + 0.5 + gauss / 2) / n, y2 = y * y;
                const double c = std::sqrt(critical + y2 * y2 * (1 - critical));
                sum += Real(fresnel_dielectric(c, eta).reflectance) * (4 * y2 * y * (1 - critical) / (2 * n));
            }
        cases.push_back({fmt::format("eta {}", eta), std::abs(found(eta) - static_cast<double>(sum)), eta});
    }
    return within_bound(cases, 1e-9, "of the light");
}

// ---- microfacets

std::vector<Vec3> inclined() {
    std::vector<Vec3> directions;
    for (const double z : {1e-100, 1e-9, 1e-4, 0.01, 0.1, 0.5, 0.9, 0.9999999}) {
        const double s = std::sqrt((1 - z) * (1 + z));
        directions.push_back({s * 0.6, s * 0.8, z});
    }
    directions.push_back({6e-9, -8e-9, 1});
    return directions;
}

constexpr std::array alphas{1e-4, 1e-2, 0.1, 0.5, 1.0};

// The share of visible facets, 1/(1 + Λ), Λ by [Heitz 2014, eq. 72 (GGX: (sqrt(1 + 1/a²) − 1)/2) and the exact
// Beckmann: (erf a − 1)/2 + exp(−a²)/(2a√π)], a = 1/(α tanθ).
template <class R>
R textbook_g1(MicrofacetShape shape, const R& alpha, Vec3 w) {
    const R s = sqrt(R(w.x) * w.x + R(w.y) * w.y), a = w.z / (alpha * s);
    if (shape == MicrofacetShape::ggx) return 2 / (1 + sqrt(1 + 1 / (a * a)));
    const R erfc_a = formulas::Elementary<R>::erfc(a), pi = formulas::Elementary<R>::pi();
    return 1 / (1 - erfc_a / 2 + exp(R(-a * a)) / (2 * a * sqrt(pi)));
}

// D in tan²θ [Walter et al. 2007, eqs. 25 and 33].
template <class R>
R textbook_d(MicrofacetShape shape, const R& alpha, Vec3 m) {
    const R z2 = R(m.z) * m.z, t2 = (R(m.x) * m.x + R(m.y) * m.y) / z2, a2 = alpha * alpha;
    const R pi = formulas::Elementary<R>::pi();
    if (shape == MicrofacetShape::ggx) return a2 / (pi * z2 * z2 * (a2 + t2) * (a2 + t2));
    return exp(R(-t2 / a2)) / (pi * a2 * z2 * z2);
}

using Term = std::function<double(const Microfacets&, Vec3)>;

double g1_towards_normal(const Microfacets& facets, Vec3 w) {
    return facets.g1(w, {0, 0, 1});
}
double d_at(const Microfacets& facets, Vec3 m) {
    return facets.d(m);
}

double g1_of_beckmann(const Microfacets& facets, Vec3 w) {
    return g1_towards_normal({MicrofacetShape::beckmann, facets.alpha}, w);
}

// [Walter et al. 2007]'s rational fit of Beckmann's masking.
double g1_fitted(const Microfacets& facets, Vec3 w) {
    const double a = w.z / (facets.alpha * std::hypot(w.x, w.y));
    return a < 1.6 ? a * (3.535 + a * 2.181) / (1 + a * (2.276 + a * 2.577)) : 1;
}

// D from z alone.
double d_by_height(const Microfacets& facets, Vec3 m) {
    const double a2 = facets.alpha * facets.alpha, t = m.z * m.z * (a2 - 1) + 1;
    return a2 / (std::numbers::pi * t * t);
}

double d_without_fourth_power(const Microfacets& facets, Vec3 m) {
    return facets.d(m) * m.z * m.z;
}

Verdict term_is(MicrofacetShape shape, const Term& found, bool masking) {
    std::vector<BoundedCase> cases;
    for (const double alpha : alphas)
        for (const Vec3 w : masking ? inclined() : [&] {
                 std::vector<Vec3> normals;
                 for (const double slope : {1e-8, 0.1, 1.0, 3.0, 5.0})
                     normals.push_back(normalize({slope * alpha * 0.6, slope * alpha * 0.8, 1}));
                 return normals;
             }()) {
            const double truth =
                static_cast<double>(masking ? textbook_g1<Real>(shape, alpha, w) : textbook_d<Real>(shape, alpha, w));
            cases.push_back({fmt::format("alpha {}, height {:.9g}", alpha, w.z),
                             ulp_error(found(Microfacets{shape, alpha}, w), truth), w.z});
        }
    return stable(cases, masking ? 16 : 128, masking ? "Smith's G1" : "D", "height of the direction");
}

void add_fresnel(Catalogue& catalogue) {
    catalogue.add(
        {.id = "bsdf/fresnel/dielectric",
         .statement =
             "A dielectric's reflectance is good to 24 ulp at grazing incidence, at nearly equal indices and on "
             "both sides of the critical angle.",
         .source = "[Born & Wolf 1999, 1.5.2]; ours, scenes/bsdfs/fresnel.cpp",
         .kind = Kind::bounded,
         .trial = {dielectric_is,
                   [](double c, double eta) { return fresnel_dielectric(c, eta).reflectance; },
                   {{"textbook", "The textbook's formula in doubles.",
                     [](double c, double eta) { return textbook_dielectric<double>(c, eta).reflectance; }},
                    {"cosines-swapped", "The two cosines change places.",
                     [](double c, double eta) {
                         const DielectricFresnel right = fresnel_dielectric(c, eta);
                         return fresnel_dielectric(right.cos_t, eta).reflectance;
                     }},
                    {"index-inverted", "The index of the near side over that of the far side.",
                     [](double c, double eta) { return fresnel_dielectric(c, 1 / eta).reflectance; }}}}});
    catalogue.add({.id = "bsdf/fresnel/conductor",
                   .statement =
                       "A conductor's reflectance is good to 24 ulp at grazing incidence, at nearly equal indices and "
                       "with next to no absorption.",
                   .source = "[Born & Wolf 1999, 14.2]; ours, scenes/bsdfs/fresnel.cpp",
                   .kind = Kind::bounded,
                   .trial = {conductor_is,
                             [](double c, double eta, double k) { return fresnel_conductor(c, eta, k); },
                             {{"textbook", "The textbook's formula in doubles.", textbook_conductor<double>},
                              {"schlick", "Schlick's approximation.", [](double c, double eta, double k) {
                                   const double normal = fresnel_conductor(1, eta, k);
                                   return normal + (1 - normal) * std::pow(1 - c, 5);
                               }}}}});
    catalogue.add({.id = "bsdf/fresnel/mean",
                   .statement = "The closed form of a dielectric's mean reflectance is its integral, from both sides.",
                   .source = "[Duntley 1942; d'Eon & Irving 2011]",
                   .kind = Kind::bounded,
                   .trial = {mean_is_integral,
                             mean_fresnel_dielectric,
                             {{"one-side", "The mean from outside on both sides.",
                               [](double eta) { return mean_fresnel_dielectric(std::max(eta, 1 / eta)); }}}}});
}

void add_microfacets(Catalogue& catalogue, MicrofacetShape shape, const std::string& name, const Wrong<Term>& masking,
                     const Wrong<Term>& distribution) {
    catalogue.add(
        {.id = fmt::format("bsdf/microfacets-{}/masking", name),
         .statement = "Smith's masking is good to 16 ulp from the horizon to the normal, at roughness 1e-4 to 1.",
         .source = "[Heitz 2014]",
         .kind = Kind::bounded,
         .trial = {[=](const Term& found) { return term_is(shape, found, true); }, g1_towards_normal, {masking}}});
    catalogue.add({.id = fmt::format("bsdf/microfacets-{}/density", name),
                   .statement = "The density of normals is good to 128 ulp within 5 roughnesses of the normal, at "
                                "roughness 1e-4 to 1.",
                   .source = "[Walter et al. 2007, eqs. 25 and 33]",
                   .kind = Kind::bounded,
                   .trial = {[=](const Term& found) { return term_is(shape, found, false); }, d_at, {distribution}}});
}

}  // namespace

void add_surfaces_bsdf_terms(Catalogue& catalogue) {
    add_fresnel(catalogue);
    constexpr auto ggx = MicrofacetShape::ggx, beckmann = MicrofacetShape::beckmann;
    add_microfacets(catalogue, ggx, "ggx", {"beckmann", "The masking of Beckmann's distribution.", g1_of_beckmann},
                    {"by-height", "The slope from 1 − cos², which cancels near the normal.", d_by_height});
    add_microfacets(catalogue, beckmann, "beckmann",
                    {"fitted", "A rational fit in place of the exact masking.", g1_fitted},
                    {"cosine-squared", "cos² for cos⁴.", d_without_fourth_power});
}

}  // namespace plumb::suites
