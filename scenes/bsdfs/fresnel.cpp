#include "scenes/bsdfs/fresnel.h"

#include <cmath>

namespace plumb {
namespace {

double squared(double x) {
    return x * x;
}

// eta² + c² − 1, which is (eta cos_t)² by Snell's law: it cancels at the critical angle, so the products' and the
// sum's rounding errors are carried along [Dekker 1971], Knuth's two-sum.
double squared_far_cosine(double eta, double c) {
    const double p = eta * eta, q = c * c, s = p + q;
    const double p_part = s - q, lost_in_sum = (p - p_part) + (q - (s - p_part));
    return (s - 1) + (lost_in_sum + (std::fma(eta, eta, -p) + std::fma(c, c, -q)));
}

}  // namespace

// With g = eta cos_t the amplitudes are r_s = (c − g)/(c + g) and r_p = (eta² c − g)/(eta² c + g). Both differences
// cancel as eta → 1; multiplied through by the sums they do not:
//   c² − g² = 1 − eta²,   eta⁴c² − g² = (eta² − 1)((eta² + 1)c² − 1) = (eta² − 1)((eta² + 1)g² − eta⁴),
// the last for eta < 1, where it does not cancel at the critical angle.
DielectricFresnel fresnel_dielectric(double cos_i, double eta) {
    const double g_squared = squared_far_cosine(eta, cos_i);
    const double contrast = (eta - 1) * (eta + 1);
    if (contrast == 0) return {0, cos_i};
    if (!(g_squared > 0)) return {1, 0};
    const double g = std::sqrt(g_squared), eta_squared = eta * eta;
    const double s = contrast / squared(cos_i + g);
    const double past_brewster =
        eta > 1 ? (eta_squared + 1) * squared(cos_i) - 1 : (eta_squared + 1) * g_squared - squared(eta_squared);
    const double p = contrast * past_brewster / squared(eta_squared * cos_i + g);
    return {std::min(1.0, (s * s + p * p) / 2), g / eta};
}

// a + ib is the root of (eta + ik)² − sin²θ. R_s = |c − (a+ib)|²/|c + (a+ib)|², and R_p/R_s likewise with sin²θ
// against c (a+ib) [Born & Wolf 1999, 14.2]. Of a and b the larger comes from its square, the other from ab = eta k;
// a − c is written without the cancellation at equal indices.
double fresnel_conductor(double cos_i, double eta, double k) {
    const double c = cos_i, sin_squared = (1 - c) * (1 + c);
    const double re = (eta - 1) * (eta + 1) + c * c - k * k, im = 2 * eta * k, modulus = std::hypot(re, im);
    double a = std::sqrt((modulus + std::abs(re)) / 2), b = a > 0 ? im / (2 * a) : 0;
    if (re < 0) std::swap(a, b);
    if (!(a + c > 0)) return 1;
    const double a_minus_c = ((eta - 1) * (eta + 1) - (k - b) * (k + b)) / (a + c);
    const double s = (squared(a_minus_c) + b * b) / (squared(a + c) + b * b);
    const double p_over_s =
        (squared(a * c - sin_squared) + squared(b * c)) / (squared(a * c + sin_squared) + squared(b * c));
    return std::min(1.0, s * (1 + p_over_s) / 2);
}

Spectrum fresnel_conductor(double cos_i, const Spectrum& eta, const Spectrum& k) {
    Spectrum reflectance;
    for (std::size_t i = 0; i < 4; ++i) reflectance[i] = fresnel_conductor(cos_i, eta[i], k[i]);
    return reflectance;
}

// [Duntley 1942], as [d'Eon & Irving 2011, appendix] print it for eta > 1.
double mean_fresnel_dielectric(double eta) {
    if (eta == 1) return 0;
    if (eta < 1) return 1 - eta * eta * (1 - mean_fresnel_dielectric(1 / eta));
    const double n = eta, n2 = n * n, n4 = n2 * n2;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * squared(n + 1)) +
           n2 * squared(n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
           2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * squared(n4 - 1)) * std::log(n);
}

}  // namespace plumb
