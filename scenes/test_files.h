#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/test_folder.h"

namespace plumb::testing_files {

/// A test with a folder for its input files.
class Folder : public testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }
    /// The message of the Error that the call throws, without the folder; "nothing" where it does not throw.
    template <class Call>
    std::string message(const Call& call) const {
        try {
            static_cast<void>(call());
        } catch (const Error& error) {
            std::string text = error.what();
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
            for (std::size_t at; (at = text.find(path_.string() + "/")) != std::string::npos;) {
                text.erase(at, path_.string().size() + 1);
            }
            return text;
        }
        return "nothing";
    }

    TestFolder folder_;
    const std::filesystem::path& path_ = folder_.path();
};

}  // namespace plumb::testing_files
