#include "reports/study/folder.h"

#include <gmock/gmock.h>

#include "core/file.h"
#include "core/test_folder.h"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::size_t entries(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(WriteFolder, ReplacesTheFolderAsAWhole) {
    const TestFolder folder;
    write_folder(folder / "deep/out", {{"a.txt", "1"}, {"b.txt", "2"}});
    write_folder(folder / "deep/out", {{"c.txt", "3"}});
    EXPECT_EQ(entries(folder / "deep/out"), 1U);
    EXPECT_EQ(read_file(folder / "deep/out/c.txt"), "3");
    EXPECT_EQ(entries(folder / "deep"), 1U) << "something was left aside";
}

TEST(WriteFolder, AcceptsATrailingSlash) {
    const TestFolder folder;
    write_folder(folder.path().string() + "/out/", {{"a.txt", "1"}});
    EXPECT_EQ(read_file(folder / "out/a.txt"), "1");
}

TEST(WriteFolder, KeepsWhatIsNotItsOwn) {
    const TestFolder folder;
    write_file(folder / "out/thesis.tex", "years of work");
    EXPECT_THAT(error_of([&] {
                    write_folder(folder / "out", {{"a.txt", "1"}});
                }),
                HasSubstr("out: holds thesis.tex, so it is not replaced"));
    EXPECT_EQ(read_file(folder / "out/thesis.tex"), "years of work");
    write_file(folder / "file", "");
    EXPECT_THAT(error_of([&] { write_folder(folder / "file", {{"a.txt", "1"}}); }), HasSubstr("is a file"));
}

TEST(WriteFolder, LeavesNothingWhenItFails) {
    const TestFolder folder;
    write_file(folder / "out/a.txt", "before");
    EXPECT_NE(error_of([&] { write_folder(folder / "out", {{"a.txt", "1"}, {"a.txt/b.txt", "2"}}); }), "");
    EXPECT_EQ(read_file(folder / "out/a.txt"), "before");
    EXPECT_EQ(entries(folder.path()), 1U);
}

}  // namespace
}  // namespace plumb::reports
