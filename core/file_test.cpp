#include "core/file.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "core/error.h"
#include "core/test_folder.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(WriteFile, MakesFoldersAndReplacesTheWholeFile) {
    const TestFolder folder;
    write_file(folder / "a/b/report.html", "a long first version");
    write_file(folder / "a/b/report.html", "second");
    EXPECT_EQ(read_file(folder / "a/b/report.html"), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "a/b"), fs::directory_iterator()), 1) << "a leftover";
}

TEST(WriteFile, NamesTheFileThatCannotBeWritten) {
    const TestFolder folder;
    fs::create_directories(folder / "taken");
    EXPECT_THAT(error_of([&] { write_file(folder / "taken", "text"); }), HasSubstr("taken: cannot be written"));
    EXPECT_THAT(error_of([&] { write_file("/proc/plumb.json", "text"); }), HasSubstr("/proc/plumb.json: cannot be"));
    write_file(folder / "file", "");
    EXPECT_THAT(error_of([&] { write_file(folder / "file/below.json", ""); }), HasSubstr("below.json: cannot be"));
}

TEST(WriteFile, KeepsLinksAndWritesToDevices) {
    const TestFolder folder;
    write_file(folder / "real/report.html", "old");
    fs::create_symlink("real/report.html", folder / "link.html");
    write_file(folder / "link.html", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link.html"));
    EXPECT_EQ(read_file(folder / "real/report.html"), "new");
    write_file("/dev/null", "nothing");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_THAT(error_of([&] { write_file("/dev/full", "text"); }),
                HasSubstr("/dev/full: cannot be written: No space"));
}

TEST(WriteFolderAside, TakesThePlaceOfTheFormerFolderOrLeavesItAsItWas) {
    const TestFolder folder;
    const auto fill = [](const char* name) {
        return [name](const fs::path& here) { write_file(here / name, "text"); };
    };
    write_folder_aside(folder / "out", fill("a.txt"));
    write_folder_aside(folder / "out", fill("b.txt"));
    EXPECT_FALSE(fs::exists(folder / "out/a.txt"));
    EXPECT_TRUE(fs::exists(folder / "out/b.txt"));
    const auto half = [](const fs::path& here) {
        write_file(here / "c.txt", "text");
        throw Error("no more");
    };
    EXPECT_EQ(error_of([&] { write_folder_aside(folder / "out", half); }), "no more");
    EXPECT_TRUE(fs::exists(folder / "out/b.txt"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1) << "a leftover";
}

TEST(WriteAside, GivesEveryWriterANameOfItsOwnWithTheExtension) {
    const TestFolder folder;
    std::vector<fs::path> names;
    write_aside(folder / "a.exr", [&](const fs::path& outer) {
        names.push_back(outer);
        write_aside(folder / "a.exr", [&](const fs::path& inner) {  // while the first is at work
            names.push_back(inner);
            write_file(inner, "inner");
            return "";
        });
        write_file(outer, "outer");
        return "";
    });
    EXPECT_NE(names[0], names[1]);
    for (const fs::path& name : names) EXPECT_EQ(name.extension(), ".exr");
    EXPECT_EQ(read_file(folder / "a.exr"), "outer") << "the last to be done";
}

TEST(WriteAside, LeavesTheOldFileWhereTheNewOneFails) {
    const TestFolder folder;
    write_file(folder / "a.exr", "old");
    const auto half = [](const fs::path& here) {
        write_file(here, "half of the ne");
        return "no more paint";
    };
    EXPECT_THAT(error_of([&] { write_aside(folder / "a.exr", half); }),
                HasSubstr("a.exr: cannot be written: no more paint"));
    EXPECT_EQ(read_file(folder / "a.exr"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1) << "a leftover";
}

// Two processes that write one picture: each reader, at any time, finds a whole one of either.
TEST(WriteAside, KeepsProcessesApart) {
    const TestFolder folder;
    const fs::path file = folder / "a.exr";
    write_file(file, std::string(100'000, 'a'));
    const pid_t child = ::fork();
    if (child == 0) {
        for (int i = 0; i < 200; ++i) write_file(file, std::string(100'000, 'b'));
        ::_exit(0);
    }
    for (int i = 0; i < 200; ++i) {
        write_file(file, std::string(100'000, 'a'));
        const std::string text = read_file(file);
        ASSERT_EQ(text, std::string(100'000, text.at(0)));
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1) << "a leftover";
}

TEST(CheckWritable, FindsWhatWriteFileWouldFindAndLeavesNothing) {
    const TestFolder folder;
    fs::create_directories(folder / "taken");
    write_file(folder / "file", "");
    for (const char* good : {"new.json", "file", "a/b/c.json"}) EXPECT_NO_THROW(check_writable(folder / good)) << good;
    EXPECT_THAT(error_of([&] { check_writable(folder / "taken"); }),
                HasSubstr("taken: cannot be written: it is a folder"));
    EXPECT_THAT(error_of([&] { check_writable(folder / "file/below/x.json"); }), HasSubstr("file is not a folder"));
    EXPECT_THAT(error_of([&] { check_writable("/proc/plumb.json"); }),
                HasSubstr("/proc/plumb.json: cannot be written"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2) << "a leftover";
}

TEST(ReadFile, NamesTheFileThatIsNotThere) {
    const TestFolder folder;
    EXPECT_THAT(error_of([&] { (void)read_file(folder / "none.json"); }), HasSubstr("none.json: cannot be read"));
    EXPECT_THAT(error_of([&] { (void)read_file(folder.path()); }), HasSubstr("not a readable file"));
}

}  // namespace
}  // namespace plumb
