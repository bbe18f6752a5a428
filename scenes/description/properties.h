#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/vec3.h"
#include "scenes/description/colour.h"
#include "scenes/description/place.h"
#include "scenes/description/transform.h"

namespace plumb::description {

/// The named values of one thing in a scene's file, whatever the file's format: a model is loaded from them. A read
/// marks its name as known to the model; the loader reports the names that nobody read. Every read throws Error naming
/// file, line, what was found and what is accepted.
class Properties {
public:
    virtual ~Properties() = default;

    /// The model that the file asks for, in Mitsuba's words: "roughconductor".
    [[nodiscard]] virtual const std::string& type() const = 0;
    [[nodiscard]] virtual const Place& place() const = 0;
    /// The place of the value, or of the thing where it lacks the value.
    [[nodiscard]] virtual const Place& place_of(const std::string& name) const = 0;
    [[nodiscard]] virtual bool has(const std::string& name) const = 0;

    virtual double number(const std::string& name, double otherwise) = 0;
    virtual int integer(const std::string& name, int otherwise) = 0;
    virtual bool boolean(const std::string& name, bool otherwise) = 0;
    virtual std::string string(const std::string& name, const std::string& otherwise) = 0;
    /// The path of an existing file, relative to the file that names it.
    virtual std::filesystem::path file(const std::string& name) = 0;
    virtual Vec3 vector(const std::string& name, Vec3 otherwise) = 0;
    virtual Transform transform(const std::string& name) = 0;
    /// An index of refraction, above 0: a number or a medium's name.
    virtual double index(const std::string& name, const std::string& otherwise) = 0;

    /// Constants, one a lane, each at least 0. Emission differs from other spectra only where the file gives a table.
    virtual Spectrum spectrum(const std::string& name, const Spectrum& otherwise) = 0;
    virtual Spectrum emission(const std::string& name, const Spectrum& otherwise) = 0;
    /// A reflectance within [0, 1] that must not be textured.
    virtual Spectrum constant_reflectance(const std::string& name, const Spectrum& otherwise) = 0;
    /// A reflectance, constant or textured, within [0, 1] where constant.
    virtual Colour reflectance(const std::string& name, const Spectrum& otherwise) = 0;

    /// The materials within this one, at least one and at most so many.
    virtual std::vector<MaterialId> nested_materials(std::size_t most) = 0;

    /// Notes that something which only advises is not followed.
    virtual void ignored(std::string text) = 0;
    /// Notes a replacement where the user is lenient, else throws `error`.
    virtual void replaced(std::string text, const Error& error) = 0;
};

/// A string in which capitals do not matter, in small letters.
std::string keyword(Properties& properties, const std::string& name, const std::string& otherwise);
/// The text in small letters.
std::string lower_case(std::string text);

/// One finite number, the whole text; throws an Error at the place.
double parse_number(const std::string& text, const Place& place);

}  // namespace plumb::description
