#include "reports/study/folder.h"

#include "core/error.h"
#include "core/file.h"

namespace plumb::reports {
namespace fs = std::filesystem;
namespace {

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
    write_folder_aside(folder, [&](const fs::path& here) {
        for (const FolderFile& file : files) write_file(here / file.name, file.text);
    });
}

}  // namespace plumb::reports
