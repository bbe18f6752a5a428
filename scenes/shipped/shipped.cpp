#include "scenes/shipped/shipped.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "scenes/shipped/known_radiances.h"

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

std::vector<std::string> shipped_scene_names() {
    const fs::path folder = shipped_folder();
    if (!fs::is_directory(folder)) throw Error(fmt::format("{}: no folder of shipped scenes", folder.string()));
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (fs::exists(entry.path() / "scene.xml") && fs::exists(entry.path() / "expected.json"))
            names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::vector<ShippedScene> shipped_scenes() {
    std::vector<ShippedScene> scenes;
    for (const std::string& name : shipped_scene_names()) {
        ShippedScene scene{.name = name, .question = {}, .file = shipped_folder() / name / "scene.xml"};
        scene.question = known_radiances(scene.expected()).question;
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

std::optional<fs::path> find_scene_file(const std::string& name_or_path) {
    if (std::error_code ignored; fs::is_regular_file(name_or_path, ignored)) return name_or_path;
    if (std::ranges::count(shipped_scene_names(), name_or_path) == 0) return {};
    return shipped_folder() / name_or_path / "scene.xml";
}

fs::path scene_file(const std::string& name_or_path) {
    if (const auto file = find_scene_file(name_or_path)) return *file;
    const fs::path path = name_or_path;
    if (path.has_extension() || path.has_parent_path())
        throw Error(fmt::format("there is no scene file {}", name_or_path));
    throw unknown_name("scene", name_or_path, shipped_scene_names());
}

std::string scene_name(const fs::path& file) {
    return file.filename() == "scene.xml" ? fs::absolute(file).parent_path().filename().string() : file.stem().string();
}

}  // namespace plumb
