#include "scenes/shipped/loaded_scene.h"

#include <fmt/format.h>

#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

LoadedScene loaded(const std::string& asked, const std::filesystem::path& file, const LoadOptions& options) {
    return {asked, file, options, Scene(load_mitsuba(file, options))};
}

}  // namespace

std::string LoadedScene::name() const {
    return scene_name(file);
}

std::string LoadedScene::hash() const {
    return fmt::format("{:016x}", scene.description().content_hash);
}

LoadedScene load_scene(const std::string& asked, const LoadOptions& options) {
    return loaded(asked, scene_file(asked), options);
}

std::shared_ptr<const LoadedScene> LoadedScenes::get(const std::string& asked) {
    const std::filesystem::path file = scene_file(asked);
    std::shared_ptr<const LoadedScene>& scene = by_file_[std::filesystem::weakly_canonical(file)];
    if (!scene) scene = std::make_shared<const LoadedScene>(loaded(asked, file, options_));
    return scene;
}

}  // namespace plumb
