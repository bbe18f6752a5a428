#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/spectrum.h"
#include "core/vec3.h"
#include "scenes/description/mesh.h"
#include "scenes/description/transform.h"

/// A loaded scene as plain data: what the file says, with references resolved to indices and defaults filled in,
/// whatever format it was written in and whoever traces rays in it.
namespace plumb::description {

/// Where in the scene's files a thing was written.
struct Place {
    std::string file = {};
    int line = 0;
    /// `file:line: message`.
    [[nodiscard]] Error error(const std::string& message) const {
        return Error(file + ":" + std::to_string(line) + ": " + message);
    }
};

// Textures -----------------------------------------------------------------------------------------------------------

enum class Wrap { repeat, mirror, clamp };

struct Bitmap {
    std::filesystem::path file;
    bool raw = false;  ///< values are taken as they are; else files of 8 and 16 bits are decoded as sRGB
    Wrap wrap = Wrap::repeat;
};

/// Squares of side 1/2: color0 around (1/4, 1/4) and (3/4, 3/4).
struct Checkerboard {
    Spectrum color0 = Spectrum::grey(0.4), color1 = Spectrum::grey(0.2);
};

struct Texture {
    std::variant<Bitmap, Checkerboard> kind;
    Transform to_uv;  ///< of a surface's (u, v, 0) before the lookup
    Place place;
};

struct TextureId {
    std::uint32_t index = 0;
    friend bool operator==(TextureId, TextureId) = default;
};

/// A number of a material for each wavelength: the same everywhere, or looked up at the hit.
using Colour = std::variant<Spectrum, TextureId>;

// Materials ----------------------------------------------------------------------------------------------------------

struct MaterialId {
    std::uint32_t index = 0;
    friend bool operator==(MaterialId, MaterialId) = default;
};

enum class Microfacets { beckmann, ggx };
struct Roughness {
    Microfacets distribution = Microfacets::beckmann;
    double alpha = 0.1;  ///< root mean square slope (Beckmann) or its analogue (GGX), > 0
};

struct Diffuse {
    Colour reflectance = Spectrum::grey(0.5);
};
/// A perfect mirror of reflectance 1 where `eta` is empty.
struct Conductor {
    std::optional<Spectrum> eta;  ///< real part of the index, relative to outside
    Spectrum k;                   ///< imaginary part
    Colour specular_reflectance = Spectrum::grey(1);
    std::optional<Roughness> roughness;
};
struct Dielectric {
    double eta = 1.5046 / 1.000277;  ///< index inside over index outside
    Colour specular_reflectance = Spectrum::grey(1), specular_transmittance = Spectrum::grey(1);
    std::optional<Roughness> roughness;
};
/// A diffuse base under a dielectric coat.
struct Plastic {
    double eta = 1.49 / 1.000277;
    Colour diffuse_reflectance = Spectrum::grey(0.5), specular_reflectance = Spectrum::grey(1);
    bool nonlinear = false;  ///< inner reflections tint the base: ρ/(1−ρF) per wavelength
    std::optional<Roughness> roughness;
};
struct TwoSided {
    MaterialId front, back;
};
struct Mask {
    Colour opacity = Spectrum::grey(0.5);
    MaterialId nested;
};

struct Material {
    std::variant<Diffuse, Conductor, Dielectric, Plastic, TwoSided, Mask> kind;
    std::string id;  ///< as the file names it, empty where it does not
    Place place;
};

// Shapes, in world space ---------------------------------------------------------------------------------------------

struct Sphere {
    Vec3 center;
    double radius = 1;
    bool flip_normals = false;  ///< the outside is inside
    Transform to_world;         ///< of the unit sphere: carries the poles of its uv
};
/// center + axis_x·x + axis_y·y, x² + y² ≤ 1.
struct Disk {
    Vec3 center, axis_x{1, 0, 0}, axis_y{0, 1, 0};
    Vec3 normal{0, 0, 1};  ///< unit
};

/// Emits this radiance from its outside.
struct AreaEmitter {
    Spectrum radiance = Spectrum::grey(1);
    Place place;
};

struct Shape {
    std::variant<Mesh, Sphere, Disk> geometry;
    MaterialId material;
    std::optional<AreaEmitter> emitter;
    std::string id;
    Place place;
};

// Emitters without a shape -------------------------------------------------------------------------------------------

struct ConstantSky {
    Spectrum radiance = Spectrum::grey(1);
};
/// Latitude and longitude, v = 0 at +y of its own space.
struct EnvironmentMap {
    std::filesystem::path file;
    double scale = 1;
    Transform to_world;
};
struct PointLight {
    Vec3 position;
    Spectrum intensity = Spectrum::grey(1);  ///< W/sr
};

struct Emitter {
    std::variant<ConstantSky, EnvironmentMap, PointLight> kind;
    Place place;
};

// Sensor and film ----------------------------------------------------------------------------------------------------

enum class FilterKind { box, tent, gaussian };
struct Filter {
    FilterKind kind = FilterKind::gaussian;
    double radius = 2;    ///< in pixels: half the support
    double stddev = 0.5;  ///< of the Gaussian, in pixels
};

struct Film {
    int width = 768, height = 576;
    Filter filter;
};

/// Looks along +z of its space, x to the image's left and y up, as Mitsuba's.
struct Sensor {
    Transform to_world;
    double fov_x = 50;  ///< full horizontal angle in degrees, whatever axis the file spoke of
    double aperture_radius = 0, focus_distance = 1;  ///< a thin lens where the radius is > 0
    Film film;
    Place place;
};

// The whole ----------------------------------------------------------------------------------------------------------

/// Something in the file that was not followed: ignored because it only advises, or replaced because lenient.
struct Note {
    enum class Kind { ignored, replaced } kind = Kind::ignored;
    Place place;
    std::string text;
};

struct Scene {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Shape> shapes;
    std::vector<Emitter> emitters;
    std::optional<Sensor> sensor;  ///< the first one of the file
    std::vector<Note> notes;
    std::uint64_t content_hash = 0;  ///< of the text after includes and $names, and of every file that it names
};

}  // namespace plumb::description
