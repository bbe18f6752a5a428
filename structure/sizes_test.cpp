// Folders and functions that a reader can take in.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "structure/source_tree.h"

namespace plumb::structure {
namespace {

bool is_code(const std::string& path) {
    return path.ends_with(".h") || path.ends_with(".cpp");
}

TEST(Folders, HoldNoMoreThanOneCanTakeIn) {
    constexpr std::size_t most_stems = 26;
    static const std::regex ending("(_test|_bench)?\\.(h|cpp)$");
    std::map<std::string, std::set<std::string>> stems;
    for (const SourceFile& file : source_files())
        if (is_code(file.path))
            stems[file.path.substr(0, file.path.rfind('/'))].insert(std::regex_replace(file.path, ending, ""));
    for (const auto& [folder, names] : stems) EXPECT_LE(names.size(), most_stems) << folder;
    EXPECT_GT(stems.size(), 30U);
}

std::size_t indentation(const std::string& line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

// A body opens at the end of a line that ends a parameter list, and closes at a brace below the start of that list's
// declaration: a line at the margin of the file or of a class.
TEST(Functions, FitAScreen) {
    constexpr std::size_t most_lines = 80, margin_in_class = 4;
    static const std::regex opening(".*\\)( const| noexcept| override)* \\{$");
    static const std::regex statement(
        "^ *(for|if|while|switch|return|[a-z_]+\\.[a-z_]+\\()");  // with a lambda, or no function
    std::size_t functions = 0;
    for (const SourceFile& file : source_files()) {
        if (!is_code(file.path)) continue;
        const std::vector<std::string> lines = lines_of(file.path);
        for (std::size_t at = 0; at < lines.size(); ++at) {
            if (!std::regex_match(lines[at], opening)) continue;
            std::size_t first = at;
            while (first > 0 && (lines[first].empty() || indentation(lines[first]) > margin_in_class)) --first;
            if (std::regex_search(lines[first], statement)) continue;
            const std::string closing = std::string(indentation(lines[first]), ' ') + "}";
            std::size_t last = at;
            while (last < lines.size() && !lines[last].starts_with(closing)) ++last;
            EXPECT_LE(last - first, most_lines) << file.path << ":" << first + 1 << ": " << lines[first];
            ++functions;
        }
    }
    EXPECT_GT(functions, 1000U);
}

// What an integrator is, its line in the list says (Makes): who asks for its name instead misses the next one.
TEST(Integrators, AreAskedWhatTheyMakeAndNotForTheirNames) {
    static const std::regex id("^ +\\{\"([a-z-]+)\",$");
    static const std::regex compared(
        "(?:==|!=|starts_with\\() ?\"([a-z-]+)\"|\"([a-z-]+)\" ?(?:==|!=)|contains\\(\"([a-z-]+)\"\\)");
    std::set<std::string> ids;
    for (const std::string& line : lines_of("integrators/integrators.cpp")) {
        std::smatch match;
        if (std::regex_match(line, match, id)) ids.insert(match[1]);
    }
    EXPECT_TRUE(ids.contains("path") && ids.contains("bdpt") && ids.size() >= 7);
    for (const SourceFile& file : source_files()) {
        const bool asks = file.path.starts_with("integrators/") || file.path.starts_with("cli/") ||
                          file.path.starts_with("studies/") || file.path.starts_with("reports/");
        if (!asks || !is_code(file.path) || file.path.ends_with("_test.cpp")) continue;
        for (const std::string& line : lines_of(file.path))
            for (std::sregex_iterator at(line.begin(), line.end(), compared), end; at != end; ++at)
                for (std::size_t group = 1; group <= 3; ++group)
                    EXPECT_FALSE((*at)[group].matched && ids.contains((*at)[group])) << file.path << ": " << line;
    }
}

}  // namespace
}  // namespace plumb::structure
