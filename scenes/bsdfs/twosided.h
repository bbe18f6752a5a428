#pragma once

#include "scenes/bsdf_model.h"

namespace plumb {

/// One model on both sides: what it does above, it does below, mirrored at the surface. For models without
/// transmission.
template <BsdfModel Model>
struct TwoSided {
    Model model;

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport transport) const {
        return model.eval(turned(wo, wo), turned(wi, wo), transport);
    }
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const { return model.pdf(turned(wo, wo), turned(wi, wo)); }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
        std::optional<BsdfSample> sample = model.sample(turned(wo, wo), u, transport);
        if (sample) sample->wi = turned(sample->wi, wo);
        return sample;
    }
    [[nodiscard]] double discrete(Vec3 wo) const { return model.discrete(turned(wo, wo)); }

private:
    // w as the model sees it when wo shall be above.
    static Vec3 turned(Vec3 w, Vec3 wo) { return wo.z < 0 ? Vec3{w.x, w.y, -w.z} : w; }
};

}  // namespace plumb
