#include <algorithm>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"
#include "scenes/spectra/metals.h"

namespace plumb::mitsuba {

using namespace description;

namespace {

Roughness load_roughness(Properties& properties, Loader& loader) {
    const Place& place = properties.element().place;
    Roughness roughness;
    roughness.alpha = properties.number("alpha", 0.1);
    if (!(roughness.alpha > 0))
        throw properties.place_of("alpha").error(
            fmt::format("alpha is {}; roughness above 0 is accepted", roughness.alpha));
    for (const char* name : {"alpha_u", "alpha_v"}) {
        if (!properties.has(name)) continue;
        roughness.alpha = properties.number(name, 0.1);
        loader.replaced(place, fmt::format("anisotropic roughness by {} = {}", name, roughness.alpha),
                        place.error("anisotropic roughness; the isotropic alpha is accepted"));
    }
    const std::string distribution = properties.string("distribution", "beckmann");
    if (distribution == "ggx") {
        roughness.distribution = Microfacets::ggx;
    } else if (distribution != "beckmann") {
        loader.replaced(place, fmt::format("distribution '{}' by beckmann", distribution),
                        place.error(unknown_name("distribution", distribution, {"beckmann", "ggx"}).what()));
    }
    properties.boolean("sample_visible", true);
    return roughness;
}

Conductor load_conductor(Properties& properties) {
    Conductor conductor;
    const std::string name = properties.string("material", "Cu");
    const Place& place = properties.element().place;
    if (properties.has("eta") != properties.has("k")) throw place.error("eta and k go together; only one is given");
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
    return conductor;
}

Dielectric load_dielectric(Properties& properties) {
    return {.eta = properties.index("int_ior", "bk7") / properties.index("ext_ior", "air"),
            .specular_reflectance = properties.reflectance("specular_reflectance", Spectrum::grey(1)),
            .specular_transmittance = properties.reflectance("specular_transmittance", Spectrum::grey(1)),
            .roughness = {}};
}

Plastic load_plastic(Properties& properties) {
    return {.eta = properties.index("int_ior", "polypropylene") / properties.index("ext_ior", "air"),
            .diffuse_reflectance = properties.reflectance("diffuse_reflectance", Spectrum::grey(0.5)),
            .specular_reflectance = properties.reflectance("specular_reflectance", Spectrum::grey(1)),
            .nonlinear = properties.boolean("nonlinear", false),
            .roughness = {}};
}

/// The <bsdf> children, refs followed.
std::vector<MaterialId> nested_materials(const XmlElement& element, Loader& loader) {
    std::vector<MaterialId> nested;
    for (const XmlElement& child : element.children) {
        if (child.tag == "ref" && loader.resolve(child).tag != "bsdf") continue;
        if (child.tag == "bsdf" || child.tag == "ref") nested.push_back(load_material(loader.resolve(child), loader));
    }
    const std::size_t most = element.attribute("type") == "twosided" ? 2 : 1;
    if (nested.empty() || nested.size() > most) {
        throw element.place.error(fmt::format("'{}' around {} bsdfs; 1{} is accepted", element.attribute("type"),
                                              nested.size(), most == 2 ? " or 2" : ""));
    }
    return nested;
}

/// The value of a material; empty where it is its child's.
std::optional<Material> load_kind(const XmlElement& element, Properties& properties, Loader& loader,
                                  MaterialId& child) {
    const std::string& type = element.attribute("type");
    Material material{
        .kind = Diffuse{}, .id = element.has("id") ? element.attribute("id") : "", .place = element.place};
    if (type == "diffuse") {
        // 0.4 wrote diffuse_reflectance.
        const auto old = properties.reflectance("diffuse_reflectance", Spectrum::grey(0.5));
        const auto reflectance = properties.reflectance("reflectance", Spectrum::grey(0.5));
        material.kind = Diffuse{properties.has("diffuse_reflectance") ? old : reflectance};
    } else if (type == "conductor" || type == "roughconductor") {
        Conductor conductor = load_conductor(properties);
        if (type == "roughconductor") conductor.roughness = load_roughness(properties, loader);
        material.kind = conductor;
    } else if (type == "dielectric" || type == "roughdielectric") {
        Dielectric dielectric = load_dielectric(properties);
        if (type == "roughdielectric") dielectric.roughness = load_roughness(properties, loader);
        material.kind = dielectric;
    } else if (type == "plastic" || type == "roughplastic") {
        Plastic plastic = load_plastic(properties);
        if (type == "roughplastic") plastic.roughness = load_roughness(properties, loader);
        material.kind = plastic;
    } else if (type == "twosided") {
        const std::vector<MaterialId> sides = nested_materials(element, loader);
        material.kind = TwoSided{sides.front(), sides.back()};
    } else if (type == "mask") {
        const Colour opacity = properties.reflectance("opacity", Spectrum::grey(0.5));
        material.kind = Mask{opacity, nested_materials(element, loader).front()};
    } else if (type == "bumpmap" || type == "normalmap" || type == "coating" || type == "roughcoating") {
        loader.replaced(element.place, fmt::format("bsdf '{}' by its child", type), loader.unknown_plugin(element));
        child = nested_materials(element, loader).front();
        return {};
    } else {
        loader.replaced(element.place, fmt::format("bsdf '{}' by grey diffuse", type), loader.unknown_plugin(element));
        return material;
    }
    properties.finish();
    return material;
}

}  // namespace

MaterialId load_material(const XmlElement& element, Loader& loader) {
    if (const auto found = loader.materials.find(&element); found != loader.materials.end()) return found->second;
    if (element.tag != "bsdf") throw element.place.error(fmt::format("<{}> where a <bsdf> is expected", element.tag));
    if (!loader.open.insert(&element).second) throw element.place.error("a bsdf that contains itself");
    Properties properties(element, loader);
    MaterialId id;
    if (std::optional<Material> material = load_kind(element, properties, loader, id)) {
        id = {static_cast<std::uint32_t>(loader.scene.materials.size())};
        loader.scene.materials.push_back(std::move(*material));
    }
    loader.open.erase(&element);
    loader.materials[&element] = id;
    return id;
}

}  // namespace plumb::mitsuba
