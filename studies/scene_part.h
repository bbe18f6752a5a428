#pragma once

#include <memory>
#include <optional>
#include <string>

#include "integrators/paths/path_estimator.h"
#include "scenes/shipped/loaded_scene.h"

namespace plumb {

/// A part of a scene's film, whose mean luminance is measured.
struct ScenePart {
    std::string id;  ///< SCENE, SCENE:x,y (a pixel) or SCENE:x,y,width,height
    std::shared_ptr<const LoadedScene> scene;
    FilmRegion region;
};

/// The part that an id names; empty where there is no such scene. Throws Error for a part that is not within the film,
/// and for what the scene's files say.
std::optional<ScenePart> scene_part(const std::string& id, LoadedScenes& scenes);

}  // namespace plumb
