#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb::testing_files {

/// A folder of its own for a test's input files, removed at the end.
class Folder : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::temp_directory_path() /
                (std::string("plumb_") + info->test_suite_name() + "_" + info->name() + "_" + std::to_string(getpid()));
        std::filesystem::create_directories(path_);
    }
    void TearDown() override { std::filesystem::remove_all(path_); }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }
    /// What the call throws, without the folder; "nothing" where it does not throw.
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

    std::filesystem::path path_;
};

}  // namespace plumb::testing_files
