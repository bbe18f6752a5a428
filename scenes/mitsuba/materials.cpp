#include <array>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using description::Material;
using description::MaterialId;

namespace {

// Bsdfs that only change how a child scatters.
constexpr std::array changes_of_a_child{"bumpmap", "normalmap", "coating", "roughcoating"};

/// What the file's version says of a conductor where the file is silent: 0.6 takes copper in air, 3 a mirror [both
/// versions' references, "conductor"].
void assume_metal(XmlProperties& properties, const XmlElement& element) {
    const bool old = element.version && *element.version < 2;
    if (old) properties.assume("ext_eta", "air");
    if (properties.has("material") || properties.has("eta") || properties.has("k")) return;
    if (!element.version)
        throw element.place.error(
            fmt::format("a {} of no metal, which is copper in scenes of version 0.6 and a mirror "
                        "in those of 3: the <scene> says no version; a material is accepted",
                        properties.type()));
    properties.assume("material", old ? "Cu" : "none");
}

/// The kind of a material; empty where the element is replaced by its child.
std::optional<decltype(Material::kind)> load_kind(const XmlElement& element, Loader& loader, MaterialId& child) {
    using Kind = decltype(Material::kind);
    XmlProperties properties(element, loader);
    if (description::serves<description::Conductor>(properties.type())) assume_metal(properties, element);
    std::optional<Kind> kind = load_model<Kind>(description::MaterialModels{}, properties);
    if (kind) {
        properties.finish();
    } else if (std::ranges::count(changes_of_a_child, properties.type())) {
        properties.replaced(fmt::format("bsdf '{}' by its child", properties.type()), loader.unknown_plugin(element));
        child = properties.nested_materials(1).front();
        element.reading.left_out = true;
    } else {
        properties.replaced(fmt::format("bsdf '{}' by grey diffuse", properties.type()),
                            loader.unknown_plugin(element));
        kind = description::Diffuse{};
        element.reading.left_out = true;
    }
    return kind;
}

}  // namespace

MaterialId load_material(const XmlElement& element, Loader& loader) {
    if (const auto found = loader.materials.find(&element); found != loader.materials.end()) return found->second;
    if (element.tag != "bsdf") throw element.place.error(fmt::format("<{}> where a <bsdf> is expected", element.tag));
    if (!loader.open.insert(&element).second) throw element.place.error("a bsdf that contains itself");
    MaterialId id;
    if (auto kind = load_kind(element, loader, id)) {
        id = {static_cast<std::uint32_t>(loader.scene.materials.size())};
        loader.scene.materials.push_back(
            {*std::move(kind), element.has("id") ? element.attribute("id") : "", element.place});
    }
    loader.open.erase(&element);
    loader.materials[&element] = id;
    return id;
}

}  // namespace plumb::mitsuba
