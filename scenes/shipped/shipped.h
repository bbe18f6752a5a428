#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// A scene that comes with Plumb.
struct ShippedScene {
    std::string name, question;
    std::filesystem::path file;  ///< its scene.xml; expected.json lies beside it

    /// The file that known_radiances() reads.
    [[nodiscard]] std::filesystem::path expected() const { return file.parent_path() / "expected.json"; }
};

/// All shipped scenes by name: an installed program has them in its ../share/plumb/scenes, another in the sources that
/// it was built from.
std::vector<ShippedScene> shipped_scenes();

/// Their names alone; reads no file.
std::vector<std::string> shipped_scene_names();

/// The file of this path if there is one, else that of the shipped scene of this name; empty where there is neither.
std::optional<std::filesystem::path> find_scene_file(const std::string& name_or_path);
/// The same. Throws Error naming the nearest where there is neither.
std::filesystem::path scene_file(const std::string& name_or_path);

/// The name of a scene's file; scene.xml goes by its folder.
std::string scene_name(const std::filesystem::path& file);

}  // namespace plumb
