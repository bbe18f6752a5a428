#include "verification/suites/surfaces/strangers_surfaces.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "scenes/bsdfs/conductor.h"
#include "scenes/bsdfs/dielectric.h"
#include "scenes/bsdfs/diffuse.h"

namespace plumb::suites {
namespace {

using checks::BsdfSubject, checks::subject_of;
using U = std::array<double, 3>;
using std::numbers::pi, std::numbers::inv_pi;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::optional<BsdfSample> smooth(Vec3 wi, const Spectrum& value, double pdf) {
    if (!(pdf > 0)) return {};
    return BsdfSample{wi, value / pdf, pdf, Measure::solid_angle, 1, 1};
}

// The cosine's complement 1 − cos of an angle, without cancellation, from unit vectors.
double versine(Vec3 a, Vec3 b) {
    return length_squared(a - b) / 2;
}

Vec3 about(Vec3 axis, double versine, double turn) {
    const double sine = std::sqrt(versine * (2 - versine)), phi = 2 * pi * turn;
    return normalize(Frame(axis).to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - versine}));
}

}  // namespace

// ---- lobes

double NarrowLobe::pdf(Vec3 wo, Vec3 wi) const {
    const double v = versine(axis(wo), wi);
    if (wo.z == 0 || v >= 1 || (!below && !same_side(wo, wi))) return 0;
    return (exponent + 1) / (2 * pi) * std::exp(exponent * std::log1p(-v));
}

std::optional<BsdfSample> NarrowLobe::sample(Vec3 wo, const U& u) const {
    const Vec3 wi = about(axis(wo), -std::expm1(std::log1p(-u[1]) / (exponent + 1)), u[2]);
    return smooth(wi, eval(wo, wi), pdf(wo, wi));
}

double Cone::pdf(Vec3 wo, Vec3 wi) const {
    return same_side(wo, wi) && versine(mirrored(wo), wi) < 1 - cosine ? 1 / (2 * pi * (1 - cosine)) : 0;
}

std::optional<BsdfSample> Cone::sample(Vec3 wo, const U& u) const {
    const Vec3 wi = about(mirrored(wo), (1 - cosine) * u[1], u[2]);
    return smooth(wi, eval(wo, wi), pdf(wo, wi));
}

// ---- a mixture

double DiffuseWithMirror::pdf(Vec3 wo, Vec3 wi) const {
    return same_side(wo, wi) ? (1 - (to - from)) * std::abs(wi.z) * inv_pi : 0;
}

Spectrum DiffuseWithMirror::eval(Vec3 wo, Vec3 wi) const {
    return same_side(wo, wi) ? Spectrum::grey(albedo * std::abs(wi.z) * inv_pi) : Spectrum{};
}

std::optional<BsdfSample> DiffuseWithMirror::sample(Vec3 wo, const U& u) const {
    if (wo.z == 0) return {};
    const double share = to - from;
    if (u[0] >= from && u[0] < to)
        return BsdfSample{mirrored(wo), Spectrum::grey(light / share), share, Measure::discrete, 1, 0};
    const double r = std::sqrt(u[1]), phi = 2 * pi * u[2];
    const Vec3 wi{r * std::cos(phi), r * std::sin(phi), std::copysign(std::sqrt(1 - u[1]), wo.z)};
    return smooth(wi, eval(wo, wi), pdf(wo, wi));
}

// ---- a metal in any precision

namespace {

template <class Real>
struct Direction {
    Real x, y, z;

    explicit Direction(Vec3 w) : Direction(Real(w.x), Real(w.y), Real(w.z)) {}
    Direction(Real a, Real b, Real c) : x(a), y(b), z(c) {}
    Direction operator+(Direction b) const { return {x + b.x, y + b.y, z + b.z}; }
    Direction operator*(Real s) const { return {x * s, y * s, z * s}; }
    [[nodiscard]] Real dot(Direction b) const { return x * b.x + y * b.y + z * b.z; }
    [[nodiscard]] Direction unit() const { return *this * (1 / std::sqrt(dot(*this))); }
};

template <class Real>
Real density_of_normals(const Metal<Real>& metal, Direction<Real> h) {
    const Real x = h.x / metal.along, y = h.y / metal.across, t = x * x + y * y + h.z * h.z;
    if (metal.along != metal.across) return 1 / (Real(pi) * metal.along * metal.across * t * t);
    const Real a2 = metal.along * metal.along, by_cosine = h.z * h.z * (a2 - 1) + 1;
    return a2 / (Real(pi) * by_cosine * by_cosine);
}

}  // namespace

template <class Real>
double Metal<Real>::pdf(Vec3 wo, Vec3 wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return 0;
    const Direction<Real> o(wo), h = (o + Direction<Real>(wi)).unit();
    return density_of_normals(*this, h) * h.z / (4 * o.dot(h));
}

template <class Real>
Spectrum Metal<Real>::eval(Vec3 wo, Vec3 wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const Direction<Real> o(wo), i(wi), h = (o + i).unit();
    const Real masking = std::min(Real(1), 2 * h.z * std::min(o.z, i.z) / o.dot(h));
    return Spectrum::grey(density_of_normals(*this, h) * masking / (4 * o.z));
}

template <class Real>
std::optional<BsdfSample> Metal<Real>::sample(Vec3 wo, const U& u) const {
    if (!(wo.z > 0)) return {};
    const Direction<Real> o(wo);
    const Real slope = std::sqrt(Real(u[1]) / (1 - Real(u[1]))), phi = Real(2 * pi) * Real(u[2]);
    const Direction<Real> h = Direction<Real>(slope * along * std::cos(phi), slope * across * std::sin(phi), 1).unit();
    const Direction<Real> i = (h * (2 * o.dot(h)) + o * Real(-1)).unit();
    if (!(i.z > 0 && o.dot(h) > 0)) return {};
    const Vec3 wi{i.x, i.y, i.z};
    const double density = pdf(wo, wi);
    if (!(density > 0)) return {};
    return BsdfSample{wi,   Spectrum::grey(Real(eval(wo, wi)[0]) / Real(density)), density, Measure::solid_angle, 1,
                      along};
}

template struct Metal<float>;
template struct Metal<double>;

// ---- true ones

namespace {

Vec3 tilted(double degrees) {
    const double tilt = degrees * pi / 180;
    return {std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, std::cos(tilt)};
}

/// A model of doubles as one of floats would have it: everything that goes in and out is rounded.
template <class Model>
BsdfSubject in_floats(const Model& model) {
    const auto narrow = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    const auto narrowed = [=](Vec3 w) { return Vec3{narrow(w.x), narrow(w.y), narrow(w.z)}; };
    BsdfSubject right = subject_of(model), bsdf = right;
    bsdf.eval = [=](Vec3 wo, Vec3 wi, Transport t) {
        Spectrum value = right.eval(narrowed(wo), narrowed(wi), t);
        for (double& lane : value.lane) lane = narrow(lane);
        return value;
    };
    bsdf.pdf = [=](Vec3 wo, Vec3 wi) { return narrow(right.pdf(narrowed(wo), narrowed(wi))); };
    bsdf.sample = [=](Vec3 wo, const U& u, Transport t) {
        auto sample = right.sample(narrowed(wo), {narrow(u[0]), narrow(u[1]), narrow(u[2])}, t);
        if (!sample) return sample;
        sample->wi = narrowed(sample->wi);
        sample->pdf = narrow(sample->pdf);
        for (double& lane : sample->weight.lane) lane = narrow(lane);
        return sample;
    };
    return bsdf;
}

}  // namespace

std::vector<StrangersSurface> true_surfaces_of_strangers() {
    std::vector<StrangersSurface> all;
    const auto add = [&](const std::string& id, const auto& model, bool quick = false) {
        all.push_back({id, subject_of(model), {}, quick});
    };
    for (const double exponent : {100., 2e4, 1e6}) {
        const bool narrowest = exponent == 1e6;
        add(fmt::format("retro {:g}", exponent), NarrowLobe{.exponent = exponent, .retro = true}, narrowest);
        add(fmt::format("tilted {:g}", exponent), NarrowLobe{.exponent = exponent, .normal = tilted(25)}, narrowest);
        add(fmt::format("below {:g}", exponent), NarrowLobe{.exponent = exponent, .normal = tilted(60), .below = true});
    }
    add("cone", Cone{}, true);
    add("narrow cone", Cone{1 - 1e-5});
    add("diffuse and mirror", DiffuseWithMirror{}, true);
    add("rare mirror", DiffuseWithMirror{.albedo = 0.9, .light = 0.005, .from = 0.4, .to = 0.405});
    add("stretched", Metal<double>{0.3, 0.02}, true);
    add("stretched far", Metal<double>{1e-2, 1e-4});
    for (const float alpha : {0.5F, 0.1F, 0.03F, 0.01F})
        add(fmt::format("floats {:g}", alpha), Metal<float>{alpha, alpha}, alpha == 0.01F);
    add("stretched floats", Metal<float>{0.3F, 0.02F});
    all.push_back({"diffuse in floats", in_floats(Diffuse{Spectrum::grey(0.5)}), {}});
    all.push_back({"glass in floats", in_floats(Dielectric{1.5}), {1, 1.5, true}});
    all.push_back({"retro 500 in floats", in_floats(NarrowLobe{.exponent = 500, .retro = true}), {}});
    return all;
}

// ---- wrong ones

namespace {

BsdfSubject squeezed_radiance() {
    BsdfSubject bad = subject_of(Diffuse{Spectrum::grey(0.5)});
    bad.sample = [right = bad.sample](Vec3 wo, const U& u, Transport t) {
        return right(wo, {u[0], t == Transport::radiance ? std::pow(u[1], 1.2) : u[1], u[2]}, t);
    };
    return bad;
}

BsdfSubject changed_samples(BsdfSubject bad, const std::function<void(BsdfSample&, Vec3 wo, const U& u)>& change) {
    bad.sample = [=, right = bad.sample](Vec3 wo, const U& u, Transport t) {
        auto sample = right(wo, u, t);
        if (sample) change(*sample, wo, u);
        return sample;
    };
    return bad;
}

BsdfSubject snell_upside_down() {
    return changed_samples(subject_of(Dielectric{1.5}), [](BsdfSample& sample, Vec3 wo, const U&) {
        if (sample.eta == 1) return;
        const double x = -wo.x * sample.eta, y = -wo.y * sample.eta, rest = 1 - x * x - y * y;
        if (rest > 0) sample.wi = {x, y, std::copysign(std::sqrt(rest), -wo.z)};
    });
}

BsdfSubject turned_about_the_normal() {
    return changed_samples(subject_of(Conductor{{}, Spectrum::grey(1)}), [](BsdfSample& sample, Vec3, const U&) {
        const double c = std::cos(pi / 18), s = std::sin(pi / 18);
        sample.wi = {c * sample.wi.x - s * sample.wi.y, s * sample.wi.x + c * sample.wi.y, sample.wi.z};
    });
}

BsdfSubject turned_down() {
    return changed_samples(subject_of(Conductor{{}, Spectrum::grey(1)}), [](BsdfSample& sample, Vec3 wo, const U&) {
        const double sine = std::hypot(wo.x, wo.y);
        const double tilt = std::min(std::atan2(sine, std::abs(wo.z)) + pi / 18, 1.57);
        if (sine > 0)
            sample.wi = {-wo.x / sine * std::sin(tilt), -wo.y / sine * std::sin(tilt),
                         std::copysign(std::cos(tilt), wo.z)};
    });
}

BsdfSubject bright_for_some(double part) {
    return changed_samples(subject_of(DiffuseWithMirror{}), [=](BsdfSample& sample, Vec3, const U& u) {
        if (sample.measure == Measure::discrete && u[1] > 0.7 && u[1] < 0.7 + part) sample.weight *= 3;
    });
}

/// A diffuse surface, changed at the directions that `where` names.
BsdfSubject matte_but(const std::function<bool(Vec3 wo, Vec3 wi)>& where, double value) {
    BsdfSubject bad = subject_of(Diffuse{Spectrum::grey(0.5)});
    bad.eval = [=, right = bad.eval](Vec3 wo, Vec3 wi, Transport t) {
        return right(wo, wi, t) * (where(wo, wi) ? value : 1);
    };
    return bad;
}

double degrees(Vec3 w) {
    return std::acos(std::min(1.0, std::abs(w.z))) * 180 / pi;
}

/// A diffuse surface whose samples take u^1.2 for u where wo is so many degrees from the normal.
BsdfSubject squeezed_between(double from, double to) {
    BsdfSubject bad = subject_of(Diffuse{Spectrum::grey(0.5)});
    bad.sample = [=, right = bad.sample](Vec3 wo, const U& u, Transport t) {
        const bool within = degrees(wo) > from && degrees(wo) < to;
        return right(wo, {u[0], within ? std::pow(u[1], 1.2) : u[1], u[2]}, t);
    };
    return bad;
}

/// A diffuse surface that loses one sample of radiance in 20.
BsdfSubject lossy_in_radiance() {
    BsdfSubject bad = subject_of(Diffuse{Spectrum::grey(0.5)});
    bad.sample = [right = bad.sample](Vec3 wo, const U& u, Transport t) {
        return t == Transport::radiance && u[0] > 0.95 ? std::nullopt : right(wo, u, t);
    };
    return bad;
}

template <class Change>
BsdfSubject float_metal(float alpha, const Change& change) {
    BsdfSubject bad = subject_of(Metal<float>{alpha, alpha});
    change(bad);
    return bad;
}

BsdfSubject float_half_vector_pdf() {
    return float_metal(0.01F, [](BsdfSubject& bad) {
        bad.pdf = [right = bad.pdf](Vec3 wo, Vec3 wi) {
            return wi.z > 0 ? right(wo, wi) * 4 * dot(wo, normalize(wo + wi)) : 0;
        };
        bad = changed_samples(bad, [](BsdfSample& sample, Vec3 wo, const U&) {
            const double factor = 4 * dot(wo, normalize(wo + sample.wi));
            sample.pdf *= factor;
            sample.weight *= 1 / factor;
        });
    });
}

BsdfSubject float_without_cosine() {
    return float_metal(0.01F, [](BsdfSubject& bad) {
        bad.eval = [right = bad.eval](Vec3 wo, Vec3 wi, Transport t) {
            return wi.z > 0 ? right(wo, wi, t) * (1 / wi.z) : Spectrum{};
        };
        bad = changed_samples(bad, [](BsdfSample& sample, Vec3, const U&) { sample.weight *= 1 / sample.wi.z; });
    });
}

BsdfSubject float_brighter_weight() {
    return float_metal(0.01F, [](BsdfSubject& bad) {
        bad = changed_samples(bad, [](BsdfSample& sample, Vec3, const U&) { sample.weight *= 1.01; });
    });
}

BsdfSubject float_narrower_samples() {
    return float_metal(0.01F, [](BsdfSubject& bad) {
        bad.sample = [](Vec3 wo, const U& u, Transport) {
            const Metal<float> narrower{0.0095F, 0.0095F}, stated{0.01F, 0.01F};
            auto sample = narrower.sample(wo, u);
            if (sample) {
                sample->pdf = stated.pdf(wo, sample->wi);
                sample->weight = stated.eval(wo, sample->wi) / sample->pdf;
            }
            return sample;
        };
    });
}

}  // namespace

std::vector<WrongStrangersSurface> wrong_surfaces_of_strangers() {
    const auto same = [](Vec3 a, Vec3 b) { return length_squared(a - b) < 1e-20; };
    const auto mirror = [](double to) {
        return subject_of(DiffuseWithMirror{.albedo = 0.9, .light = 0.3, .from = 0.41, .to = to});
    };
    return {
        {"values", "NaN where wi is wo.", {"nan-back", matte_but(same, nan)}},
        {"values",
         "NaN where wi is −wo.",
         {"nan-straight-on", matte_but([=](Vec3 wo, Vec3 wi) { return same(wo, -wi); }, nan)}},
        {"values",
         "NaN where wi lies in the surface.",
         {"nan-level-wi", matte_but([](Vec3, Vec3 wi) { return wi.z == 0; }, nan)}},
        {"values",
         "NaN where wo lies in the surface.",
         {"nan-level-wo", matte_but([](Vec3 wo, Vec3) { return wo.z == 0; }, nan)}},
        {"values",
         "NaN beyond 89.6 degrees.",
         {"nan-grazing", matte_but([](Vec3 wo, Vec3) { return degrees(wo) > 89.6; }, nan)}},
        {"sample", "Directions take u^1.2 for u in radiance alone.", {"squeezed-radiance", squeezed_radiance()}},
        {"sample",
         "In floats, samples are of roughness 0.0095 for 0.01.",
         {"float-narrower", float_narrower_samples()}},
        {"pdf", "Directions take u^1.2 for u from 21 to 29 degrees.", {"squeezed-between", squeezed_between(21, 29)}},
        {"pdf", "Directions take u^1.2 for u beyond 89.6 degrees.", {"squeezed-grazing", squeezed_between(89.6, 90)}},
        {"pdf",
         "In floats, the density is per steradian of half vectors.",
         {"float-half-vector", float_half_vector_pdf()}},
        {"weight", "A mirror weighs 3 times as much for a tenth of u[1].", {"bright-for-some", bright_for_some(0.1)}},
        {"weight",
         "A mirror weighs 3 times as much for a hundredth of u[1].",
         {"bright-for-few", bright_for_some(0.01)}},
        {"weight", "In floats, weights are 1.01 times too large.", {"float-brighter", float_brighter_weight()}},
        {"mass", "One sample of radiance in 20 is lost.", {"lossy-radiance", lossy_in_radiance()}},
        {"reciprocity",
         "Light refracts as if it came from the other side.",
         {"snell-upside-down", snell_upside_down(), {1, 1.5, true}}},
        {"reciprocity",
         "A mirror turns its directions by 10 degrees about the normal.",
         {"turned", turned_about_the_normal()}},
        {"reciprocity",
         "A mirror turns its directions by 10 degrees towards the horizon.",
         {"turned-down", turned_down()}},
        {"reciprocity", "In floats, the value lacks its cosine.", {"float-no-cosine", float_without_cosine()}},
        {"energy", "A mirror amid u[0], undeclared, adds 30 % of light.", {"undeclared-mirror", mirror(0.46)}},
        {"energy", "A mirror that is chosen once in 500 times adds 30 % of light.", {"rare-mirror", mirror(0.412)}},
    };
}

}  // namespace plumb::suites
