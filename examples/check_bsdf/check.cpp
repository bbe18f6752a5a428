// `check` puts the renderer's surface on trial, `check wrong` its twin: a line a property, exit code 0 if all hold.

#include <cstring>
#include <iostream>

#include "checks/bsdf/check_bsdf.h"
#include "oren_nayar.h"

/// The renderer's surface under Plumb's conventions: this much is to be written.
template <class Bsdf>
struct OnTrial {
    Bsdf bsdf;

    static renderer::Direction ours(plumb::Vec3 w) { return {w.x, w.y, w.z}; }

    /// f times the cosine.
    plumb::Spectrum eval(plumb::Vec3 wo, plumb::Vec3 wi) const {
        const renderer::Colour f = bsdf.f(ours(wo), ours(wi));
        return plumb::Spectrum::rgb(f.r, f.g, f.b) * std::abs(wi.z);
    }
    double pdf(plumb::Vec3 wo, plumb::Vec3 wi) const { return bsdf.pdf(ours(wo), ours(wi)); }
    /// u[0] would choose among several lobes; empty where nothing scatters: from below.
    std::optional<plumb::BsdfSample> sample(plumb::Vec3 wo, const std::array<double, 3>& u) const {
        if (wo.z <= 0) return {};
        const renderer::Direction w = bsdf.sample(u[1], u[2]);
        const plumb::Vec3 wi{w.x, w.y, w.z};
        const double density = pdf(wo, wi);
        return plumb::BsdfSample{.wi = wi,
                                 .weight = eval(wo, wi) / density,
                                 .pdf = density,
                                 .measure = plumb::Measure::solid_angle,
                                 .roughness = 1};
    }
};

template <class Bsdf>
int report(const Bsdf& bsdf) {
    bool all_hold = true;
    for (const plumb::checks::NamedVerdict& named : plumb::checks::check_bsdf(OnTrial<Bsdf>{bsdf})) {
        std::cout << named << '\n';
        all_hold &= named.verdict.outcome == plumb::Outcome::holds;
    }
    return all_hold ? 0 : 1;
}

int main(int argc, char** argv) {
    const bool wrong = argc > 1 && std::strcmp(argv[1], "wrong") == 0;
    return wrong ? report(renderer::WrongOrenNayar{}) : report(renderer::OrenNayar{});
}
