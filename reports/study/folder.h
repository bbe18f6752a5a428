#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumb::reports {

struct FolderFile {
    std::string name, text;
};

/// Throws Error unless the folder may be replaced: it is not there yet or holds nothing but files with these extensions
/// (".csv"). The message names what else it holds, or why nothing can be written beside it.
void check_replaceable(const std::filesystem::path& folder, const std::vector<std::string>& extensions);

/// Makes a folder with exactly these files: it is written aside, then renamed into place, so that readers see the old
/// folder or the new one. Throws Error as check_replaceable() does with the files' own extensions, or naming what
/// cannot be written.
void write_folder(const std::filesystem::path& folder, const std::vector<FolderFile>& files);

}  // namespace plumb::reports
