#include "reports/study/folder.h"

#include <unistd.h>

#include "core/error.h"
#include "core/file.h"

namespace plumb::reports {
namespace fs = std::filesystem;
namespace {

/// Renames and removals that must not pass silently.
template <class Action>
void must(const fs::path& folder, const Action& action) {
    std::error_code error;
    action(error);
    if (error) throw Error(fmt::format("{}: cannot be replaced: {}", folder.string(), error.message()));
}

fs::path without_slash(const fs::path& folder) {
    return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

void check_replaceable(const fs::path& given, const std::vector<std::string>& extensions) {
    const fs::path folder = without_slash(given);
    check_writable(folder.string() + ".part");
    if (!fs::exists(folder)) return;
    if (!fs::is_directory(folder)) throw Error(fmt::format("{}: is a file; a folder is needed", folder.string()));
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || std::ranges::find(extensions, extension) == extensions.end())
            throw Error(fmt::format("{}: holds {}, so it is not replaced; give an empty or a new folder",
                                    folder.string(), entry.path().filename().string()));
    }
}

void write_folder(const fs::path& given, const std::vector<FolderFile>& files) {
    const fs::path folder = without_slash(given);
    std::vector<std::string> extensions;
    for (const FolderFile& file : files) extensions.push_back(fs::path(file.name).extension().string());
    check_replaceable(folder, extensions);
    const fs::path aside = folder.string() + fmt::format(".{}.part", ::getpid());
    const fs::path before = folder.string() + fmt::format(".{}.old", ::getpid());
    std::error_code ignored;
    try {
        for (const FolderFile& file : files) write_file(aside / file.name, file.text);
        const bool replaces = fs::exists(folder);
        if (replaces) must(folder, [&](std::error_code& error) { fs::rename(folder, before, error); });
        must(folder, [&](std::error_code& error) {
            fs::rename(aside, folder, error);
            if (error && replaces) fs::rename(before, folder, ignored);
        });
    } catch (...) {
        fs::remove_all(aside, ignored);
        throw;
    }
    fs::remove_all(before, ignored);
}

}  // namespace plumb::reports
