#include "reports/file.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "reports/test_folder.h"

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

TEST(ReadFile, NamesTheFileThatIsNotThere) {
    const TestFolder folder;
    EXPECT_THAT(error_of([&] { (void)read_file(folder / "none.json"); }), HasSubstr("none.json: cannot be read"));
    EXPECT_THAT(error_of([&] { (void)read_file(folder.path()); }), HasSubstr("not a readable file"));
}

}  // namespace
}  // namespace plumb
