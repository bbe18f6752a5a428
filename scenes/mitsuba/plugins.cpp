#include "scenes/mitsuba/plugins.h"

#include "core/error.h"

namespace plumb {

const std::vector<Plugin>& known_plugins() {
    static const std::vector<Plugin> all{
        {"bsdf", "conductor", "a smooth metal by its complex index, or a perfect mirror"},
        {"bsdf", "dielectric", "a smooth interface, as of glass: reflects and refracts"},
        {"bsdf", "diffuse", "Lambert's surface"},
        {"bsdf", "mask", "another bsdf where it is opaque, nothing elsewhere"},
        {"bsdf", "plastic", "a diffuse base under a smooth dielectric coat"},
        {"bsdf", "roughconductor", "a rough metal: Beckmann or GGX microfacets, visible normals"},
        {"bsdf", "roughdielectric", "a rough interface: Beckmann or GGX microfacets, visible normals"},
        {"bsdf", "roughplastic", "a diffuse base under a rough dielectric coat"},
        {"bsdf", "twosided", "one bsdf on both sides, or one on each"},
        {"emitter", "area", "the outside of a shape shines with one radiance to every side"},
        {"emitter", "constant", "the same radiance from every direction"},
        {"emitter", "envmap", "radiance by direction, from a picture in latitude and longitude"},
        {"emitter", "point", "one point with the same intensity to every side"},
        {"film", "hdrfilm", "pixels of unbounded values"},
        {"rfilter", "box", "constant over its support"},
        {"rfilter", "gaussian", "Gaussian, cut off at four standard deviations"},
        {"rfilter", "tent", "falls linearly to the ends of its support"},
        {"sensor", "perspective", "a pinhole camera"},
        {"sensor", "thinlens", "a camera with a lens, in focus at one distance"},
        {"shape", "cube", "[-1,1]^3"},
        {"shape", "disk", "the unit disk at z = 0"},
        {"shape", "obj", "a mesh from a Wavefront file"},
        {"shape", "ply", "a mesh from a PLY file, of text or binary"},
        {"shape", "rectangle", "[-1,1]^2 at z = 0"},
        {"shape", "sphere", "a sphere, not of triangles"},
        {"texture", "bitmap", "a picture, looked up bilinearly"},
        {"texture", "checkerboard", "squares of two colours"},
    };
    return all;
}

std::vector<std::string> plugin_names(const std::string& kind) {
    std::vector<std::string> names;
    for (const Plugin& plugin : known_plugins())
        if (plugin.kind == kind) names.push_back(plugin.name);
    if (names.empty()) throw Error(fmt::format("no plugins of the kind '{}'", kind));
    return names;
}

}  // namespace plumb
