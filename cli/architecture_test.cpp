// The arrows between the folders, as docs and design draw them: who may include whom.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> allowed = {
    {"core", {"core"}},
    {"analytic", {"core", "analytic"}},
    {"estimators", {"core", "analytic", "estimators"}},
    {"scenes", {"core", "analytic", "estimators", "scenes"}},
    {"integrators", {"core", "scenes", "estimators", "integrators"}},
    {"verification", {"core", "verification"}},
    {"checks", {"core", "estimators", "scenes", "verification", "checks"}},
    {"verification/suites",
     {"core", "analytic", "estimators", "scenes", "integrators", "verification", "checks", "verification/suites"}},
    {"reports", {"core", "verification", "reports"}},
    {"studies", {"core", "analytic", "estimators", "scenes", "integrators", "verification", "reports", "studies"}},
    {"cli",
     {"core", "analytic", "estimators", "scenes", "integrators", "verification", "verification/suites", "checks",
      "reports", "studies", "cli"}},
};

std::string folder_of(const std::string& path) {
    if (path.starts_with("verification/suites/")) return "verification/suites";
    return path.substr(0, path.find('/'));
}

class Arrows : public testing::TestWithParam<std::string> {};

TEST_P(Arrows, PointOnlyWhereTheyMay) {
    const fs::path root = PLUMB_SOURCE_DIR;
    int read = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / GetParam())) {
        const std::string path = fs::relative(entry.path(), root).string();
        if (folder_of(path) != GetParam() || path.find("node_modules") != std::string::npos) continue;
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        ++read;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with("#include \"")) continue;
            const std::string target = folder_of(line.substr(10));
            EXPECT_TRUE(allowed.at(GetParam()).contains(target)) << path << ": " << line;
        }
    }
    EXPECT_GT(read, 0);
}

INSTANTIATE_TEST_SUITE_P(Folders, Arrows, testing::ValuesIn([] {
                             std::vector<std::string> folders;
                             for (const auto& [folder, targets] : allowed) folders.push_back(folder);
                             return folders;
                         }()));

}  // namespace
