// Citations and the bibliography, docs/sources.md, hold each other.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "structure/source_tree.h"

namespace plumb::structure {
namespace {

/// The first column of the bibliography.
std::set<std::string> cited_as() {
    std::set<std::string> keys;
    for (const std::string& line : lines_of("docs/sources.md")) {
        const std::size_t end = line.find(" | ");
        if (line.starts_with("| ") && end != std::string::npos) keys.insert(line.substr(2, end - 2));
    }
    keys.erase("cited as");
    return keys;
}

/// The key that one of the parts of a citation begins with: up to its year, or a name without one.
std::string key_of(const std::string& part) {
    static const std::regex key("^ *((?:thesis|IEC [0-9-]+)|[^0-9]*?\\b(?:1[6-9]|20)[0-9][0-9]\\b)");
    std::smatch found;
    return std::regex_search(part, found, key) ? found[1].str() : part;
}

struct Citation {
    std::string key, file;
};

/// What stands in brackets and holds a year, or a name of the bibliography that has none.
std::vector<Citation> citations() {
    static const std::regex bracket(
        "\\[((?:thesis\\b|IEC [0-9]|(?:[A-Z]|van "
        "|d')[^\\[\\]\"<>{}=()]*?\\b(?:1[6-9]|20)[0-9][0-9]\\b)[^\\[\\]]*)\\](?!\\()");
    std::vector<Citation> all;
    for (const SourceFile& file : source_files()) {
        if (file.path == "docs/sources.md" || file.path == "structure/sources_test.cpp") continue;
        for (std::sregex_iterator at(file.text.begin(), file.text.end(), bracket), end; at != end; ++at) {
            const std::string inside = (*at)[1];
            for (std::size_t begin = 0; begin <= inside.size();) {
                const std::size_t stop = std::min(inside.find(';', begin), inside.size());
                all.push_back({key_of(inside.substr(begin, stop - begin)), file.path});
                begin = stop + 1;
            }
        }
    }
    return all;
}

TEST(Sources, EveryCitationHasAnEntry) {
    const std::set<std::string> known = cited_as();
    ASSERT_GT(known.size(), 50u);
    for (const auto& [key, file] : citations())
        EXPECT_TRUE(known.contains(key)) << file << " cites [" << key << "], which docs/sources.md lacks";
}

TEST(Sources, EveryEntryIsCited) {
    std::set<std::string> cited;
    for (const Citation& citation : citations()) cited.insert(citation.key);
    for (const std::string& key : cited_as()) EXPECT_TRUE(cited.contains(key)) << "nobody cites [" << key << "]";
}

TEST(Sources, AreNamedInBracketsOnly) {
    for (const std::string& key : cited_as()) {
        if (key.find_first_of("0123456789") == std::string::npos) continue;  // a word that sentences have too
        for (const SourceFile& file : source_files()) {
            if (file.path == "docs/sources.md" || file.path == "structure/sources_test.cpp") continue;
            for (std::size_t at = file.text.find(key); at != std::string::npos; at = file.text.find(key, at + 1)) {
                const std::size_t open = file.text.rfind('[', at), close = file.text.rfind(']', at);
                const bool bracketed = open != std::string::npos && (close == std::string::npos || close < open);
                EXPECT_TRUE(bracketed) << file.path << " names " << key << " without brackets: …"
                                       << file.text.substr(at, key.size() + 20) << "…";
            }
        }
    }
}

}  // namespace
}  // namespace plumb::structure
