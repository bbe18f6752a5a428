#pragma once

// What the parts of the Mitsuba loader share; nobody else includes it.

#include <map>
#include <optional>
#include <set>
#include <string>

#include "scenes/mitsuba/mitsuba_xml.h"

namespace plumb::mitsuba {

/// `toWorld` and `to_world` are one name, as are `intIOR` and `int_ior`.
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

/// The named values of one element: <float name="…"/> and its like. Every read marks a name as known.
class Properties {
public:
    Properties(const XmlElement& element, Loader& loader);

    [[nodiscard]] bool has(const std::string& name) const { return values_.contains(name); }
    double number(const std::string& name, double otherwise);
    int integer(const std::string& name, int otherwise);
    bool boolean(const std::string& name, bool otherwise);
    std::string string(const std::string& name, const std::string& otherwise);
    /// A file, relative to the file that names it; throws where it does not exist.
    std::filesystem::path file(const std::string& name);
    Vec3 vector(const std::string& name, Vec3 otherwise);
    /// A colour that must not be textured, of lanes from 0. Emission and reflectance differ for tabulated spectra
    /// alone.
    Spectrum spectrum(const std::string& name, const Spectrum& otherwise, bool emission = false);
    /// A reflectance, constant or textured, within [0, 1] where constant.
    description::Colour reflectance(const std::string& name, const Spectrum& otherwise);
    /// One that must not be textured.
    Spectrum constant_reflectance(const std::string& name, const Spectrum& otherwise);
    Transform transform(const std::string& name);
    /// An index of refraction: a number or a medium's name.
    double index(const std::string& name, const std::string& otherwise);

    /// To be called when all has been read: what nobody asked for is an Error, or a note where it only advises.
    void finish(bool advisory = false);

    [[nodiscard]] const XmlElement& element() const { return element_; }
    /// Where the value stands, or the element that lacks it.
    [[nodiscard]] const description::Place& place_of(const std::string& name) const;

private:
    const XmlElement* take(const std::string& name);
    Spectrum constant(const std::string& name, const Spectrum& otherwise, bool emission, double most);

    const XmlElement& element_;
    Loader& loader_;
    std::map<std::string, const XmlElement*> values_;
    std::set<std::string> known_;
};

/// One finite number, the whole text; throws an Error at the place.
double parse_number(const std::string& text, const description::Place& place);
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
