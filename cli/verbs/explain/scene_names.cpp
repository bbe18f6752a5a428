#include "cli/verbs/explain/scene_names.h"

#include <fmt/format.h>

namespace plumb::cli {

std::string SceneName::text() const {
    const std::string quoted = id.empty() ? "" : fmt::format(" '{}'", id);
    return fmt::format("{} {}{} ({}:{})", kind, index, quoted, std::filesystem::path(place.file).filename().string(),
                       place.line);
}

SceneName name_of_shape(const Scene& scene, std::uint32_t shape) {
    const description::Shape& found = scene.description().shapes[shape];
    return {"shape", shape, found.id, found.place};
}

SceneName name_of_material(const Scene& scene, std::uint32_t shape) {
    const std::uint32_t index = scene.description().shapes[shape].material.index;
    const description::Material& found = scene.description().materials[index];
    return {"material", index, found.id, found.place};
}

SceneName name_of_light(const Scene& scene, std::size_t light) {
    const auto& [textures, materials, shapes, emitters, sensor, integrator, notes, hash] = scene.description();
    std::size_t next = 0;
    for (const description::Shape& shape : shapes)
        if (shape.emitter && next++ == light) return {"light", light, shape.id, shape.emitter->place};
    return {"light", light, "", emitters[light - next].place};
}

std::string name_of_bsdf(const Bsdf& bsdf) {
    return std::string(bsdf.name());
}

}  // namespace plumb::cli
