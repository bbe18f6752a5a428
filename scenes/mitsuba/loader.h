#pragma once

// This header holds what the parts of the Mitsuba loader share; nobody else includes it.

#include <map>
#include <optional>
#include <set>
#include <string>

#include "scenes/mitsuba/mitsuba_xml.h"

namespace plumb::mitsuba {

/// The one spelling of a name: `to_world` for `toWorld`, `int_ior` for `intIOR`.
std::string snake_case(const std::string& name);

/// The state of loading one file.
struct Loader {
    LoadOptions options;
    description::Scene scene = {};
    std::map<std::string, const XmlElement*> named = {};  ///< elements of the root by their id
    std::map<const XmlElement*, description::MaterialId> materials = {};
    std::map<const XmlElement*, description::TextureId> textures = {};
    std::set<std::filesystem::path> files = {};  ///< named by what was loaded
    std::set<const XmlElement*> open = {};       ///< materials being loaded: a ref to one of them is a cycle

    /// The element itself, or the one that a <ref id="…"/> names.
    const XmlElement& resolve(const XmlElement& element) const;
    void ignored(const description::Place& place, std::string text);
    /// Notes a replacement when lenient, else throws `error`.
    void replaced(const description::Place& place, std::string text, const Error& error);
    /// The Error for a plugin that we lack: names the plugin, its place and those that exist.
    [[nodiscard]] Error unknown_plugin(const XmlElement& element) const;
};

/// The named values of one element: <float name="…"/> and its like.
class XmlProperties final : public description::Properties {
public:
    XmlProperties(const XmlElement& element, Loader& loader);

    [[nodiscard]] const std::string& type() const override { return element_.attribute("type"); }
    [[nodiscard]] const description::Place& place() const override { return element_.place; }
    [[nodiscard]] const description::Place& place_of(const std::string& name) const override;
    [[nodiscard]] bool has(const std::string& name) const override { return values_.contains(name); }

    double number(const std::string& name, double otherwise) override;
    int integer(const std::string& name, int otherwise) override;
    bool boolean(const std::string& name, bool otherwise) override;
    std::string string(const std::string& name, const std::string& otherwise) override;
    std::filesystem::path file(const std::string& name) override;
    Vec3 vector(const std::string& name, Vec3 otherwise) override;
    Transform transform(const std::string& name) override;
    double index(const std::string& name, const std::string& otherwise) override;
    Spectrum spectrum(const std::string& name, const Spectrum& otherwise) override;
    Spectrum emission(const std::string& name, const Spectrum& otherwise) override;
    Spectrum constant_reflectance(const std::string& name, const Spectrum& otherwise) override;
    description::Colour reflectance(const std::string& name, const Spectrum& otherwise) override;
    std::vector<description::MaterialId> nested_materials(std::size_t most) override;
    void ignored(std::string text) override { loader_.ignored(element_.place, std::move(text)); }
    void replaced(std::string text, const Error& error) override {
        loader_.replaced(element_.place, std::move(text), error);
    }

    /// Ends the reading: a value that nobody asked for is an Error, or a note where it only advises.
    void finish(bool advisory = false);

private:
    const XmlElement* take(const std::string& name);
    Spectrum constant(const std::string& name, const Spectrum& otherwise, bool emission, double most);

    const XmlElement& element_;
    Loader& loader_;
    std::map<std::string, const XmlElement*> values_;
    std::set<std::string> known_;
};

Spectrum parse_spectrum(const XmlElement& element, bool emission);
Transform parse_transform(const XmlElement& element);
Vec3 parse_vector(const XmlElement& element, Vec3 otherwise);

description::TextureId load_texture(const XmlElement& element, Loader& loader);
description::MaterialId load_material(const XmlElement& element, Loader& loader);
description::Shape load_shape(const XmlElement& element, Loader& loader);
description::AreaEmitter load_area_emitter(const XmlElement& element, Loader& loader);
description::Emitter load_emitter(const XmlElement& element, Loader& loader);
description::Sensor load_sensor(const XmlElement& element, Loader& loader);

}  // namespace plumb::mitsuba
