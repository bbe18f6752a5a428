#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "core/file.h"
#include "core/test_folder.h"

namespace plumb::cli {

/// The output of the program when it was called in a folder of the test's own.
struct Said {
    int exit_code = -1;
    std::string out, error;
};

class CommandTest : public testing::Test {
protected:
    /// Runs the program with `arguments` as one types them in a shell.
    Said plumb(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder.path().string() + "' && '" PLUMB_PROGRAM "' " + arguments + " >.out 2>.err";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder / ".out"), read_file(folder / ".err")};
    }

    void write(const std::string& name, const std::string& text) const { write_file(folder / name, text); }
    [[nodiscard]] std::string read(const std::string& name) const { return read_file(folder / name); }

    /// The one line of an input error; nothing but it and the test's own files may be there afterwards.
    std::string complaint(const std::string& arguments) const {
        const std::size_t before = files();
        const Said said = plumb(arguments);
        EXPECT_EQ(said.exit_code, 2) << arguments;
        EXPECT_EQ(said.out, "") << arguments;
        EXPECT_EQ(std::count(said.error.begin(), said.error.end(), '\n'), 1) << said.error;
        EXPECT_TRUE(said.error.starts_with("plumb: ")) << said.error;
        EXPECT_EQ(files(), before) << "left files after " << arguments;
        return said.error;
    }

    TestFolder folder;

private:
    [[nodiscard]] std::size_t files() const {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
            count += entry.path().filename() != ".out" && entry.path().filename() != ".err";
        return count;
    }
};

}  // namespace plumb::cli
