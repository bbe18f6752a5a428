#include "structure/source_tree.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace plumb::structure {
namespace {

namespace fs = std::filesystem;

const fs::path root = PLUMB_SOURCE_DIR;
const std::set<std::string> passed_over = {".git", "build", "out", "node_modules", "additions"};
const std::set<std::string> kinds = {".h", ".cpp", ".md", ".toml", ".json", ".py", ".cmake"};

std::string sentences(std::string text) {
    static const std::regex next_literal("\"\\s*\n\\s*\""), next_line("\n[ \t]*(///?<?|#)?[ \t]*");
    text = std::regex_replace(text, next_literal, "");
    return std::regex_replace(text, next_line, " ");
}

std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return std::move(text).str();
}

}  // namespace

const std::vector<SourceFile>& source_files() {
    static const std::vector<SourceFile> files = [] {
        std::vector<SourceFile> found;
        for (fs::recursive_directory_iterator at(root), end; at != end; ++at) {
            const std::string name = at->path().filename().string();
            if (at->is_directory() && passed_over.contains(name)) at.disable_recursion_pending();
            if (!at->is_regular_file() || name.starts_with("package")) continue;
            if (kinds.contains(at->path().extension()) || name == "CMakeLists.txt")
                found.push_back({fs::relative(at->path(), root).string(), sentences(read(at->path()))});
        }
        return found;
    }();
    return files;
}

std::vector<std::string> lines_of(const std::string& path) {
    std::vector<std::string> lines;
    std::ifstream file(root / path);
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

bool exists(const std::string& path) {
    return fs::exists(root / path);
}

}  // namespace plumb::structure
