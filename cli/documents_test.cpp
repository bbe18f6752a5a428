// What the documents print is what the program does: options that it has, and outputs as they stand.

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "cli/command_test.h"

namespace plumb::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Block {
    std::string file;
    std::vector<std::string> lines;
};

std::vector<fs::path> documents() {
    const fs::path root(PLUMB_SOURCE_DIR);
    std::vector<fs::path> files{root / "README.md"};
    for (const auto& entry : fs::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    return files;
}

// Between ``` and ```, and indented calls.
std::vector<Block> blocks() {
    std::vector<Block> all;
    for (const fs::path& file : documents()) {
        std::istringstream text(read_file(file));
        bool inside = false;
        for (std::string line; std::getline(text, line);) {
            if (line.starts_with("```")) {
                inside = !inside;
                if (inside) all.push_back({file.filename().string(), {}});
            } else if (inside) {
                all.back().lines.push_back(line);
            } else if (line.starts_with("    plumb ") || line.starts_with("    ./plumb ")) {
                all.push_back({file.filename().string(), {line}});
            }
        }
    }
    return all;
}

// Whether the text is the pattern, in which … stands for anything.
bool is_like(std::string_view text, std::string_view pattern) {
    constexpr std::string_view anything = "…";
    const std::size_t at = pattern.find(anything);
    if (at == std::string_view::npos) return text == pattern;
    if (!text.starts_with(pattern.substr(0, at))) return false;
    text.remove_prefix(at);
    pattern.remove_prefix(at + anything.size());
    for (std::size_t skip = 0; skip <= text.size(); ++skip)
        if (is_like(text.substr(skip), pattern)) return true;
    return false;
}

class Documents : public CommandTest {};

TEST_F(Documents, PrintOutputsAsTheyAre) {
    int tried = 0;
    for (const Block& block : blocks()) {
        if (block.lines.empty() || !block.lines.front().starts_with("$ plumb ")) continue;
        const Said said = plumb(block.lines.front().substr(8));
        std::string expected;
        for (std::size_t i = 1; i < block.lines.size(); ++i) expected += block.lines[i] + "\n";
        EXPECT_TRUE(is_like(said.out, expected)) << block.file << ": " << block.lines.front() << "\nprints\n"
                                                 << said.out << "and the document\n"
                                                 << expected;
        ++tried;
    }
    EXPECT_GT(tried, 0);
}

// The words of a line up to a comment, a pipe or the next command.
std::vector<std::string> words_of(std::string line) {
    for (const char* end : {"  #", " | ", " && ", " # "}) line = line.substr(0, line.find(end));
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

TEST_F(Documents, NameVerbsAndOptionsThatThereAre) {
    std::map<std::string, std::string> helps;
    for (const Block& block : blocks())
        for (const std::string& line : block.lines) {
            std::vector<std::string> words = words_of(line.starts_with("$ ") ? line.substr(2) : line);
            if (words.size() < 2 || (words[0] != "plumb" && words[0] != "./plumb")) continue;
            if (words[1] == "test" || words[1] == "build" || words[1].starts_with('-')) continue;  // the launcher's
            std::string& help = helps[words[1]];
            if (help.empty()) help = plumb(words[1] + " --help").out;
            EXPECT_THAT(help, HasSubstr("Usage:")) << block.file << ": " << line;
            for (std::size_t i = 2; i < words.size(); ++i) {
                std::string word = words[i];
                if (word.starts_with('[')) word.erase(0, 1);
                if (!word.starts_with("--") || word == "--") continue;
                word = word.substr(0, word.find_first_of("=]"));
                EXPECT_THAT(help, HasSubstr(word)) << block.file << ": " << line;
            }
        }
    EXPECT_GT(helps.size(), 8U);
}

TEST_F(Documents, HaveAManualAndACompletionOfEveryVerb) {
    const std::string manual = plumb("manual").out, completion = plumb("manual --completion").out;
    for (const char* verb : {"verify", "integrate", "render", "compare"}) {
        EXPECT_THAT(manual, HasSubstr(std::string(".SS ") + verb));
        EXPECT_THAT(completion, HasSubstr(std::string(verb) + ") words='--"));
    }
    write("completion", completion);
    write("try.sh", ". ./completion; COMP_WORDS=(plumb compare --til); COMP_CWORD=2; _plumb; echo \"${COMPREPLY[@]}\"");
    ASSERT_EQ(std::system(("cd '" + folder.path().string() + "' && bash try.sh >tried").c_str()), 0);
    EXPECT_THAT(read("tried"), testing::AnyOf("--tile-delta --tile\n", "--tile --tile-delta\n"));
}

}  // namespace
}  // namespace plumb::cli
