// The launcher ./plumb, in a tree of a few files where nothing is installed and everything is built.

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>

#include "core/file.h"
#include "core/test_folder.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Launcher : public testing::Test {
protected:
    Launcher() {
        const fs::path launcher = folder / "plumb";
        fs::copy_file(fs::path(PLUMB_SOURCE_DIR) / "plumb", launcher);
        write_file(folder / "packages.txt", "# a comment\nlib-one\nlib-two\nshell sh\n");
        write_file(folder / "reports/page/package-lock.json", "");
        write_file(folder / "reports/page/node_modules/.package-lock.json", "");
        write_file(folder / "build/release/build.ninja", "build plumb: phony\n");
        program("build/release/cli/plumb", "echo called \"$@\"");
        program("bin/dpkg-query", "echo >>asked; cat installed");
        program("bin/id", "echo 1000");
        program("bin/sudo", "exit 1");
        write_file(folder / "installed", "lib-one install ok installed\nlib-two install ok installed\n");
        age("packages.txt");
        age("reports/page/package-lock.json");
    }

    void program(const std::string& name, const std::string& text) const {
        write_file(folder / name, "#!/bin/sh\n" + text + "\n");
        fs::permissions(folder / name, fs::perms::owner_all);
    }
    // As if it had been written a while ago: timestamps decide.
    void age(const std::string& name) const {
        fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::minutes(1));
    }
    int call(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder.path().string() + "' && PATH=\"$PWD/bin:$PATH\" ./plumb " + arguments + " >out 2>err";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    // How often dpkg was asked so far.
    [[nodiscard]] std::size_t asked() const {
        return fs::exists(folder / "asked") ? read_file(folder / "asked").size() : 0;
    }

    const TestFolder folder;
};

TEST_F(Launcher, AsksForPackagesOnce) {
    for (int time = 0; time < 3; ++time) {
        EXPECT_EQ(call("verify --seed 7"), 0) << read_file(folder / "err");
        EXPECT_EQ(read_file(folder / "out"), "called verify --seed 7\n");
        EXPECT_EQ(asked(), 1U);
    }
    write_file(folder / "packages.txt", "lib-one\n");
    fs::last_write_time(folder / "packages.txt", fs::file_time_type::clock::now() + std::chrono::minutes(1));
    EXPECT_EQ(call("list"), 0);
    EXPECT_EQ(asked(), 2U) << "the list is newer than the answer";
}

TEST_F(Launcher, NamesWhatIsMissing) {
    write_file(folder / "installed", "lib-one install ok installed\nlib-two deinstall ok config-files\n");
    for (int time = 0; time < 2; ++time) {
        EXPECT_EQ(call("verify"), 2);
        EXPECT_THAT(read_file(folder / "err"), HasSubstr("apt-get install --no-install-recommends -y lib-two \n"));
    }
    EXPECT_EQ(asked(), 2U) << "what is missing is asked for again";
}

TEST_F(Launcher, SaysWhyABuildFailed) {
    write_file(folder / "build/release/build.ninja", "rule no\n  command = echo broken; false\nbuild plumb: no\n");
    EXPECT_EQ(call("verify"), 2);
    EXPECT_THAT(read_file(folder / "err"), testing::AllOf(HasSubstr("the build failed"), HasSubstr("broken")));
}

}  // namespace
}  // namespace plumb
