#include "verification/suites/surfaces/bsdf_defects.h"

#include <fmt/format.h>

namespace plumb::suites {

using checks::BsdfSubject;
using U = std::array<double, 3>;

namespace {

double cosine(Vec3 w) {
    return std::abs(w.z);
}

BsdfSubject squeezed_direction(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.sample = [right = s.bsdf.sample](Vec3 wo, const U& u, Transport t) {
        return right(wo, {u[0], std::pow(u[1], 1.1), u[2]}, t);
    };
    return bad;
}

BsdfSubject pdf_without_cosine(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.pdf = [right = s.bsdf.pdf](Vec3 wo, Vec3 wi) { return wi.z == 0 ? 0 : right(wo, wi) / cosine(wi); };
    return bad;
}

BsdfSubject eval_without_cosine(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.eval = [right = s.bsdf.eval](Vec3 wo, Vec3 wi, Transport t) { return right(wo, wi, t) / cosine(wi); };
    return bad;
}

BsdfSubject eval_with_cosine_twice(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.eval = [right = s.bsdf.eval](Vec3 wo, Vec3 wi, Transport t) { return right(wo, wi, t) * cosine(wi); };
    return bad;
}

Defect brighter(double factor) {
    return [=](const SurfaceSubject& s) { return scaled(s, [=](double, bool, Transport) { return factor; }); };
}

BsdfSubject reflection_scaled_as_if_refracted(const SurfaceSubject& s) {
    return scaled(s, [](double, bool, Transport t) { return t == Transport::radiance ? 1 / 2.25 : 1; });
}

BsdfSubject discrete_everywhere(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.discrete = [right = s.bsdf.discrete](Vec3 wo) { return 0.5 * right(wo) + 0.25; };
    return bad;
}

BsdfSubject half_the_probability(const SurfaceSubject& s) {
    return with_samples(s, [](BsdfSample& sample, Vec3, Transport) { sample.pdf *= 0.5; });
}

BsdfSubject half_the_pdf(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.pdf = [right = s.bsdf.pdf](Vec3 wo, Vec3 wi) { return right(wo, wi) / 2; };
    return bad;
}

}  // namespace

BsdfSubject with_samples(const SurfaceSubject& s, const std::function<void(BsdfSample&, Vec3 wo, Transport)>& change) {
    BsdfSubject bad = s.bsdf;
    bad.sample = [=, right = s.bsdf.sample](Vec3 wo, const U& u, Transport t) {
        auto sample = right(wo, u, t);
        if (sample) change(*sample, wo, t);
        return sample;
    };
    return bad;
}

BsdfSubject eval_swapped(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.eval = [right = s.bsdf.eval](Vec3 wo, Vec3 wi, Transport t) { return right(wi, wo, t); };
    return bad;
}

BsdfSubject scaled(const SurfaceSubject& s, const std::function<double(double eta, bool crosses, Transport)>& factor) {
    const double index = s.traits.eta;
    const auto of = [=](Vec3 wo, Vec3 wi, Transport t) {
        return factor(wo.z > 0 ? index : 1 / index, !same_side(wo, wi), t);
    };
    BsdfSubject bad =
        with_samples(s, [=](BsdfSample& sample, Vec3 wo, Transport t) { sample.weight *= of(wo, sample.wi, t); });
    bad.eval = [=, right = s.bsdf.eval](Vec3 wo, Vec3 wi, Transport t) { return right(wo, wi, t) * of(wo, wi, t); };
    return bad;
}

BsdfSubject eta_squared_missing(const SurfaceSubject& s) {
    return scaled(
        s, [](double eta, bool crosses, Transport t) { return crosses && t == Transport::radiance ? eta * eta : 1; });
}

BsdfSubject eta_squared_on_both_sides(const SurfaceSubject& s) {
    return scaled(s, [](double eta, bool crosses, Transport t) {
        return crosses && t == Transport::importance ? 1 / (eta * eta) : 1;
    });
}

BsdfSubject eta_squared_upside_down(const SurfaceSubject& s) {
    return scaled(s, [](double eta, bool crosses, Transport t) {
        return crosses && t == Transport::radiance ? std::pow(eta, 4) : 1;
    });
}

BsdfSubject transmission_doubled(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.eval = [right = s.bsdf.eval](Vec3 wo, Vec3 wi, Transport t) {
        return right(wo, wi, t) * (same_side(wo, wi) ? 1 : 2);
    };
    return bad;
}

BsdfSubject weight_without_share(const SurfaceSubject& s) {
    return with_samples(s, [](BsdfSample& sample, Vec3, Transport) { sample.weight *= 0.5; });
}

BsdfSubject chosen_too_often(const SurfaceSubject& s) {
    BsdfSubject bad = s.bsdf;
    bad.sample = [right = s.bsdf.sample](Vec3 wo, const U& u, Transport t) {
        return right(wo, {std::pow(u[0], 1.1), u[1], u[2]}, t);
    };
    return bad;
}

std::vector<NamedDefect> common_defects(double energy_factor) {
    return {
        {"sample", "squeezed", "Directions take u^1.1 for u.", squeezed_direction},
        {"pdf", "no-cosine", "The density lacks its cosine.", pdf_without_cosine},
        {"weight", "no-cosine", "The value lacks its cosine.", eval_without_cosine},
        {"mass", "no-cosine", "The density lacks its cosine.", pdf_without_cosine},
        {"reciprocity", "cosine-twice", "The value has its cosine twice.", eval_with_cosine_twice},
        {"eta-squared", "scaled-reflection", "Reflected radiance is scaled as if refracted.",
         reflection_scaled_as_if_refracted},
        {"energy", "too-bright", fmt::format("All values are {} times too large.", energy_factor),
         brighter(energy_factor)},
    };
}

std::vector<NamedDefect> defects_of_mixtures(double energy_factor) {
    std::vector<NamedDefect> defects = common_defects(energy_factor);
    for (NamedDefect& defect : defects)
        if (defect.property == "pdf")
            defect = {"pdf", "half", "The density is halved, as if two lobes were equally likely.", half_the_pdf};
    return defects;
}

std::vector<NamedDefect> discrete_defects() {
    return {
        {"weight", "half-the-probability", "Half of a lobe's probability is announced.", half_the_probability},
        {"mass", "discrete", "discrete() is half of what is said, and a quarter.", discrete_everywhere},
        {"eta-squared", "scaled-reflection", "Reflected radiance is scaled as if refracted.",
         reflection_scaled_as_if_refracted},
        {"energy", "too-bright", "All weights are 1.003 times too large.", brighter(1.003)},
    };
}

}  // namespace plumb::suites
