// A path that a comment, a document or a claim's source names leads somewhere.
#include <gtest/gtest.h>

#include <regex>

#include "structure/source_tree.h"

namespace plumb::structure {
namespace {

TEST(Paths, ThatAreNamedExist) {
    static const std::regex path(
        "(^|[^\\w./-])((?:analytic|checks|cli|cmake|core|docs|estimators|examples|integrators|reports|scenes|structure|"
        "studies|verification)/[\\w./-]*\\.(?:h|cpp|md|toml|cmake|json|xml|py|inc))\\b");
    int named = 0;
    for (const SourceFile& file : source_files()) {
        if (file.path.ends_with("CMakeLists.txt") || file.path.ends_with(".cmake")) continue;  // relative; CMake looks
        for (std::sregex_iterator at(file.text.begin(), file.text.end(), path), end; at != end; ++at) {
            const std::string name = (*at)[2];
            if (name.find("NAME") != std::string::npos) continue;  // stands for any
            ++named;
            EXPECT_TRUE(exists(name) || exists(name + ".in")) << file.path << " names " << name;
        }
    }
    EXPECT_GT(named, 100);
}

}  // namespace
}  // namespace plumb::structure
