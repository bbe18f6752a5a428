#include "scenes/shipped/loaded_scene.h"

#include <fmt/format.h>

#include "scenes/shipped/shipped.h"

namespace plumb {

std::string NamedScene::name() const {
    return scene_name(file);
}

std::string NamedScene::hash() const {
    return fmt::format("{:016x}", content_hash);
}

ReadScene read_scene(const std::string& asked, const LoadOptions& options) {
    const std::filesystem::path file = scene_file(asked);
    description::Scene description = load_mitsuba(file, options);
    return {{asked, file, options, description.content_hash}, std::move(description)};
}

LoadedScene made_ready(ReadScene scene) {
    return {static_cast<NamedScene>(scene), Scene(std::move(scene.description))};
}

LoadedScene load_scene(const std::string& asked, const LoadOptions& options) {
    return made_ready(read_scene(asked, options));
}

std::shared_ptr<const LoadedScene> LoadedScenes::get(const std::string& asked) {
    std::shared_ptr<const LoadedScene>& scene = by_file_[std::filesystem::weakly_canonical(scene_file(asked))];
    if (!scene) scene = std::make_shared<const LoadedScene>(load_scene(asked, options_));
    return scene;
}

}  // namespace plumb
