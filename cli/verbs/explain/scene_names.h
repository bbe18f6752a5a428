#pragma once

#include <string>

#include "scenes/bsdfs/bsdf.h"
#include "scenes/scene.h"

namespace plumb::cli {

/// A thing of a scene, as its file has it.
struct SceneName {
    std::string kind;  ///< e.g. "shape"
    std::size_t index;
    std::string id;  ///< empty where the file gives none
    description::Place place;

    /// "shape 3 'floor' (scene.xml:40)"
    [[nodiscard]] std::string text() const;
};

SceneName name_of_shape(const Scene& scene, std::uint32_t shape);
/// The material of the shape: two-sided ones and masks by their own names.
SceneName name_of_material(const Scene& scene, std::uint32_t shape);
/// The light at an index into Scene::lights(): those of shapes come first.
SceneName name_of_light(const Scene& scene, std::size_t light);
/// The closure's plugin in Mitsuba's XML, e.g. "roughconductor".
std::string name_of_bsdf(const Bsdf& bsdf);

}  // namespace plumb::cli
