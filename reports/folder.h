#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

struct FolderFile {
    std::string name, text;
};

/// A folder with exactly these files: written aside, then renamed into place, so that readers see the old folder or the
/// new one. An existing folder is replaced only when all it holds are files with an extension of one of these;
/// throws Error naming what else it holds, or what cannot be written.
void write_folder(const std::filesystem::path& folder, const std::vector<FolderFile>& files);

}  // namespace plumb
