#pragma once

#include <functional>
#include <optional>

#include "scenes/bsdfs/bsdf_model.h"

namespace plumb::checks {

/// The functions of a model on trial, so that a mutant can change one. discrete is empty when the model cannot tell.
struct BsdfSubject {
    std::function<Spectrum(Vec3 wo, Vec3 wi, Transport)> eval;
    std::function<double(Vec3 wo, Vec3 wi)> pdf;
    std::function<std::optional<BsdfSample>(Vec3 wo, const std::array<double, 3>& u, Transport)> sample;
    std::function<double(Vec3 wo)> discrete;
};

/// The properties of a model that the checks must know.
struct BsdfTraits {
    double roughness = 1;   ///< of its narrowest smooth lobe, as Beckmann's or Trowbridge's alpha in [1e-6, 1]: eval()
                            ///< may peak so narrowly at the mirrored or refracted direction though no sample goes there
    double eta = 1;         ///< index inside over index outside, where it refracts
    bool lossless = false;  ///< all that arrives from above leaves again
    double epsilon = 0;  ///< relative error of one operation of its arithmetic, up to 2^-11; 0: floats or doubles, as
                         ///< its samples show
};

/// Throws Error for traits outside their ranges.
void require_valid(const BsdfTraits& traits);

// The concepts of a model on trial follow scenes/bsdfs/bsdf_model.h; a model without transmission may leave out the
// transport argument, and any model may leave out discrete.
template <class Model>
concept EvaluatesByTransport = requires(const Model& model, Vec3 wo, Vec3 wi, Transport transport) {
    { model.eval(wo, wi, transport) } -> std::convertible_to<Spectrum>;
};
template <class Model>
concept Evaluates = EvaluatesByTransport<Model> || requires(const Model& model, Vec3 wo, Vec3 wi) {
    { model.eval(wo, wi) } -> std::convertible_to<Spectrum>;
};
template <class Model>
concept HasPdf = requires(const Model& model, Vec3 wo, Vec3 wi) {
    { model.pdf(wo, wi) } -> std::convertible_to<double>;
};
template <class Model>
concept SamplesByTransport = requires(const Model& model, Vec3 wo, const std::array<double, 3>& u,
                                      Transport transport) {
    { model.sample(wo, u, transport) } -> std::convertible_to<std::optional<BsdfSample>>;
};
template <class Model>
concept Samples = SamplesByTransport<Model> || requires(const Model& model, Vec3 wo, const std::array<double, 3>& u) {
    { model.sample(wo, u) } -> std::convertible_to<std::optional<BsdfSample>>;
};

/// The subject that a model of any type with eval, pdf and sample is. The model is copied, and its functions are called
/// from several threads.
template <class Model>
BsdfSubject subject_of(const Model& model) {
    static_assert(Evaluates<Model>, "needs: Spectrum eval(Vec3 wo, Vec3 wi) const, or (wo, wi, Transport)");
    static_assert(HasPdf<Model>, "needs: double pdf(Vec3 wo, Vec3 wi) const");
    static_assert(Samples<Model>,
                  "needs: std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u) const, or (wo, u, "
                  "Transport)");
    BsdfSubject subject;
    if constexpr (Evaluates<Model> && HasPdf<Model> && Samples<Model>) {  // else the messages above are all there is
        subject.eval = [model](Vec3 wo, Vec3 wi, Transport transport) -> Spectrum {
            if constexpr (EvaluatesByTransport<Model>)
                return model.eval(wo, wi, transport);
            else
                return model.eval(wo, wi);
        };
        subject.pdf = [model](Vec3 wo, Vec3 wi) -> double { return model.pdf(wo, wi); };
        subject.sample = [model](Vec3 wo, const std::array<double, 3>& u,
                                 Transport transport) -> std::optional<BsdfSample> {
            if constexpr (SamplesByTransport<Model>)
                return model.sample(wo, u, transport);
            else
                return model.sample(wo, u);
        };
        if constexpr (requires(Vec3 wo) { model.discrete(wo); })
            subject.discrete = [model](Vec3 wo) -> double { return model.discrete(wo); };
    }
    return subject;
}

}  // namespace plumb::checks
