#include "scenes/bsdfs/conductor.h"

#include "scenes/bsdfs/bsdf.h"
#include "scenes/bsdfs/fresnel.h"
#include "scenes/spectra/metals.h"

namespace plumb {

std::optional<BsdfSample> Conductor::sample(Vec3 wo, const std::array<double, 3>&, Transport) const {
    if (!(wo.z > 0)) return {};
    return BsdfSample{mirrored(wo), reflectance * fresnel_conductor(wo.z, eta, k), 1, Measure::discrete, 1, 0};
}

Spectrum Conductor::albedo() const {
    return reflectance * fresnel_conductor(1, eta, k);
}

namespace description {

Conductor Conductor::load(Properties& properties) {
    Conductor conductor;
    const std::string name = properties.string("material", "none");
    const Place& place = properties.place();
    if (properties.has("eta") != properties.has("k")) throw place.error("eta and k go together; only one is given");
    if (properties.has("eta") && name != "none")
        throw properties.place_of("material").error("material is given, and eta and k too; one way is accepted");
    const double outside = properties.index("ext_eta", "vacuum");
    if (properties.has("eta")) {
        conductor.eta = properties.spectrum("eta", {}) / outside;
        conductor.k = properties.spectrum("k", {}) / outside;
    } else if (name != "none") {
        try {
            const ComplexIndex index = metal(name);
            conductor.eta = index.eta / outside;
            conductor.k = index.k / outside;
        } catch (const Error& error) {
            throw place.error(error.what());
        }
    }
    conductor.specular_reflectance = properties.reflectance("specular_reflectance", Spectrum::grey(1));
    if (properties.type() == "roughconductor") conductor.roughness = Roughness::load(properties);
    return conductor;
}

Bsdf Conductor::at(const Lookup& lookup) const {
    const Spectrum reflectance = lookup.colour(specular_reflectance);
    const Spectrum real = eta.value_or(Spectrum{}), imaginary = eta ? k : Spectrum::grey(1);
    if (roughness) return {RoughConductor{roughness->facets(), real, imaginary, reflectance}};
    return {plumb::Conductor{real, imaginary, reflectance}};
}

}  // namespace description

}  // namespace plumb
