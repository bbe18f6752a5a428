#pragma once

// This header holds what the parts of the Mitsuba loader share; nobody else includes it.

#include <list>
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
    Folders folders = {};
    description::Scene scene = {};
    std::map<std::string, const XmlElement*> named = {};  ///< elements by their id
    std::set<std::string> referred = {};                  ///< ids to which a <ref> or an <alias> leads
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

/// The tags that a value may have, and the words in which an error says so.
struct Form {
    std::vector<std::string> tags;
    std::string_view text;
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

    /// The children of this tag, refs followed.
    std::vector<const XmlElement*> parts(const std::string& tag);
    /// The one child of this tag, refs followed; null where there is none. Throws Error for a second one.
    const XmlElement* part(const std::string& tag);
    /// Gives a value that the file's version implies where the file has none.
    void assume(const std::string& name, const std::string& value);

    /// Takes a value, if there is one, that has no effect.
    void pass_over(const std::string& name);
    /// Ends the reading: notes what is known to have no effect; what else nobody asked for is an Error.
    void finish();

private:
    const XmlElement* take(const std::string& name, const Form& form);
    [[nodiscard]] Error lacks(const std::string& name) const;
    Spectrum constant(const std::string& name, const Spectrum& otherwise, bool emission, double most);

    const XmlElement& element_;
    Loader& loader_;
    std::map<std::string, const XmlElement*> values_;
    std::list<XmlElement> assumed_;
};

/// Fills Loader::named and Loader::referred. Throws Error for an id that two have.
void index_references(const XmlElement& root, Loader& loader);
/// Reports bsdfs and textures at the root to which no <ref> leads: an Error where none can, else a note.
void report_unreferred(const XmlElement& root, Loader& loader);
/// The place in words, without the file where that is the same.
std::string as_seen_from(const description::Place& place, const description::Place& from);

/// Whether Mitsuba has elements of this tag.
bool is_known_tag(const std::string& tag);
/// Whether elements of this tag are values, which have a name.
bool is_value(const std::string& tag);
/// Reports elements of no tag that Mitsuba knows, as report_unread() does, before anybody misses what they were meant
/// as.
void report_unknown_tags(const XmlElement& element, Loader& loader);
/// Reports what nobody asked for of an element and of what was read within it: an Error with the place, what was found
/// and what is accepted; a note where the user is lenient. It is reported once.
void report_unread(const XmlElement& element, Loader& loader);
/// Names of values of a tag that Mitsuba knows and that have no effect on what Plumb computes.
const std::vector<std::string>& names_without_effect(const std::string& tag);
/// The integrator where Plumb has it; one that it lacks is noted with all that is in it.
std::optional<description::Integrator> load_integrator(const XmlElement& element, Loader& loader);
/// Notes a sampler, which is not followed; what nobody knows of samplers is an Error.
void pass_over_sampler(const XmlElement& element, Loader& loader);

Spectrum parse_spectrum(const XmlElement& element, bool emission);
/// The map of a <transform>: of space, or of a texture's (u, v), whose matrices of nine numbers are those of the plane.
Transform parse_transform(const XmlElement& element, bool of_texture = false);
Vec3 parse_vector(const XmlElement& element, Vec3 otherwise);

description::TextureId load_texture(const XmlElement& element, Loader& loader);
description::MaterialId load_material(const XmlElement& element, Loader& loader);
description::Shape load_shape(const XmlElement& element, Loader& loader);
description::AreaEmitter load_area_emitter(const XmlElement& element, Loader& loader);
description::Emitter load_emitter(const XmlElement& element, Loader& loader);
description::Sensor load_sensor(const XmlElement& element, Loader& loader);
/// The camera of a scene that names none, as Mitsuba's: of 45 degrees, along +z, whose width the shapes' longest side
/// fills, were it their front.
description::Sensor default_sensor(const XmlElement& scene, Loader& loader);

}  // namespace plumb::mitsuba
