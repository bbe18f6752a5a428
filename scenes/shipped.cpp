#include "scenes/shipped.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "scenes/known_radiances.h"

namespace plumb {

namespace {

namespace fs = std::filesystem;

fs::path shipped_folder() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    const fs::path installed = program.parent_path() / "share/plumb/scenes";
    return fs::is_directory(installed, ignored) ? installed : fs::path(PLUMB_SCENES_FOLDER);
}

}  // namespace

std::vector<ShippedScene> shipped_scenes() {
    const fs::path folder = shipped_folder();
    if (!fs::is_directory(folder)) throw Error(fmt::format("{}: no folder of shipped scenes", folder.string()));
    std::vector<ShippedScene> scenes;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        ShippedScene scene{
            .name = entry.path().filename().string(), .question = {}, .file = entry.path() / "scene.xml"};
        if (!fs::exists(scene.file) || !fs::exists(scene.expected())) continue;
        scene.question = known_radiances(scene.expected()).question;
        scenes.push_back(std::move(scene));
    }
    std::ranges::sort(scenes, {}, &ShippedScene::name);
    return scenes;
}

fs::path scene_file(const std::string& name_or_path) {
    const fs::path path = name_or_path;
    if (fs::is_regular_file(path)) return path;
    if (path.has_extension() || path.has_parent_path())
        throw Error(fmt::format("there is no scene file {}", name_or_path));
    std::vector<std::string> known;
    for (const ShippedScene& scene : shipped_scenes()) {
        if (scene.name == name_or_path) return scene.file;
        known.push_back(scene.name);
    }
    throw unknown_name("scene", name_or_path, known);
}

}  // namespace plumb
