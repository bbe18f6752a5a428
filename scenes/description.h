#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenes/bsdfs/all.h"
#include "scenes/emitters/all.h"
#include "scenes/geometry/shape.h"
#include "scenes/sensors/all.h"
#include "scenes/textures/texture.h"

/// A loaded scene as plain data: what the file says, with references resolved to indices and defaults filled in,
/// whatever format the file has and whoever traces rays in the scene. Each family of models has its list: all.h in
/// scenes/{textures,bsdfs,geometry,emitters,sensors}, and scenes/film/filters.h.
namespace plumb::description {

/// A thing in the file that was not followed: ignored because it only advises, or replaced because the reader is
/// lenient.
struct Note {
    enum class Kind { ignored, replaced } kind = Kind::ignored;
    Place place;
    std::string text;
};

/// The integrator that a file asks for, in Plumb's words, and which paths: advice to whoever renders the scene.
struct Integrator {
    std::string name;                                   ///< "path"
    std::optional<int> longest = {}, roulette_at = {};  ///< in edges from the sensor; longest −1: no limit
};

/// A scene as its file describes it.
struct Scene {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Shape> shapes;
    std::vector<Emitter> emitters;
    std::optional<Sensor> sensor;          ///< the first one of the file
    std::optional<Integrator> integrator;  ///< where the file names one that Plumb has
    std::vector<Note> notes;
    std::uint64_t content_hash = 0;  ///< of the text after includes and $names, and of every file that it names
};

}  // namespace plumb::description
