#pragma once

#include <filesystem>
#include <string>

#include "scenes/description.h"
#include "scenes/mitsuba/xml_tree.h"

namespace plumb {

/// The options with which a scene's file is read.
struct LoadOptions {
    Definitions definitions = {};  ///< values for $name, before the file's <default>
    bool lenient = false;          ///< replace what we lack where a replacement exists, and list it in Scene::notes
};

/// Loads a scene in Mitsuba's XML, of 0.5/0.6 (toWorld, intIOR) or 3 (to_world, int_ior); meshes are read, image files
/// only named. docs/scenes.md says what is followed. Throws Error naming file, line and value.
description::Scene load_mitsuba(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace plumb
