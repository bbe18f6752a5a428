#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/scene.h"

namespace plumb {

/// A scene that a user named, read and made ready: all that renders, references, studies and metadata know of it.
struct LoadedScene {
    std::string asked;  ///< as the user wrote it: a file, or the name of a shipped scene
    std::filesystem::path file;
    LoadOptions options;  ///< the values of $name that the user gave, among them
    Scene scene;

    /// What its pictures and references are called.
    [[nodiscard]] std::string name() const;
    /// Of the content of its files, in the form that metadata have.
    [[nodiscard]] std::string hash() const;
};

/// Throws Error for what is no scene, naming the nearest, and for what its files say.
LoadedScene load_scene(const std::string& asked, const LoadOptions& options = {});

/// The scenes of a command that may name one several times: each file is loaded once.
class LoadedScenes {
public:
    explicit LoadedScenes(LoadOptions options = {}) : options_(std::move(options)) {}

    /// As load_scene(); `asked` stays as the file was called first.
    std::shared_ptr<const LoadedScene> get(const std::string& asked);

private:
    LoadOptions options_;
    std::map<std::filesystem::path, std::shared_ptr<const LoadedScene>> by_file_;
};

}  // namespace plumb
