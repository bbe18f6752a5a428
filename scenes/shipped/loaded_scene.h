#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/scene.h"

namespace plumb {

/// A scene that a user named: all that references and metadata know of it.
struct NamedScene {
    std::string asked;  ///< as the user wrote it: a file, or the name of a shipped scene
    std::filesystem::path file;
    LoadOptions options;  ///< the values of $name that the user gave, among them
    std::uint64_t content_hash;

    /// What its pictures and references are called.
    [[nodiscard]] std::string name() const;
    /// The hash of the content of its files, in the form that metadata have.
    [[nodiscard]] std::string hash() const;
};

/// The scene as its files describe it. Making it ready takes as long again.
struct ReadScene : NamedScene {
    description::Scene description;
};

/// The scene made ready for rays: all that renders and studies know of it.
struct LoadedScene : NamedScene {
    Scene scene;
};

/// Reads the scene's files. Throws Error for what is no scene, naming the nearest, and for what its files say.
ReadScene read_scene(const std::string& asked, const LoadOptions& options = {});
/// Makes the scene ready. Throws Error for what its files say.
LoadedScene made_ready(ReadScene scene);
/// Both steps in one.
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
