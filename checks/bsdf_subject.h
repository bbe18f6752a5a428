#pragma once

#include <functional>
#include <optional>

#include "scenes/bsdf_model.h"

namespace plumb::checks {

/// The functions of a model on trial, so that a mutant can change one. discrete is empty when the model cannot tell.
struct BsdfSubject {
    std::function<Spectrum(Vec3 wo, Vec3 wi, Transport)> eval;
    std::function<double(Vec3 wo, Vec3 wi)> pdf;
    std::function<std::optional<BsdfSample>(Vec3 wo, const std::array<double, 3>& u, Transport)> sample;
    std::function<double(Vec3 wo)> discrete;
};

/// Any type with eval, pdf and sample under the conventions of scenes/bsdf_model.h; the transport argument may be left
/// out by a model without transmission, discrete by any.
template <class Model>
BsdfSubject subject_of(const Model& model) {
    using U = std::array<double, 3>;
    BsdfSubject subject;
    subject.eval = [model](Vec3 wo, Vec3 wi, Transport transport) {
        if constexpr (requires { model.eval(wo, wi, transport); })
            return Spectrum{model.eval(wo, wi, transport)};
        else
            return Spectrum{model.eval(wo, wi)};
    };
    subject.pdf = [model](Vec3 wo, Vec3 wi) { return model.pdf(wo, wi); };
    subject.sample = [model](Vec3 wo, const U& u, Transport transport) {
        if constexpr (requires { model.sample(wo, u, transport); })
            return std::optional<BsdfSample>{model.sample(wo, u, transport)};
        else
            return std::optional<BsdfSample>{model.sample(wo, u)};
    };
    if constexpr (requires(Vec3 wo) { model.discrete(wo); })
        subject.discrete = [model](Vec3 wo) { return model.discrete(wo); };
    return subject;
}

}  // namespace plumb::checks
