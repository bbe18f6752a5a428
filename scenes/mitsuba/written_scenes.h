#pragma once

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/test_files.h"

namespace plumb::testing_files {

/// A test of scenes that are written in a line or two.
class WrittenScenes : public Folder {
protected:
    description::Scene load(const std::string& body, const LoadOptions& options = {}) const {
        return load_mitsuba(write("scene.xml", "<scene version=\"3.0.0\">\n" + body + "</scene>"), options);
    }
    std::string says(const std::string& body) const {
        return message([&] { return load(body); });
    }
    std::string says_of_file(const std::string& text) const {
        return message([&] { return load_mitsuba(write("scene.xml", text)); });
    }
    /// Each body is an error that begins so.
    void expect_errors(const std::vector<std::pair<std::string, std::string>>& cases) const {
        for (const auto& [body, expected] : cases) EXPECT_EQ(says(body).substr(0, expected.size()), expected) << body;
    }
};

inline std::string shape(const std::string& inner) {
    return "<shape type=\"sphere\">" + inner + "</shape>";
}
inline std::string bsdf(const std::string& type, const std::string& inner) {
    return "<bsdf type=\"" + type + "\" id=\"a\">" + inner + "</bsdf>";
}
inline std::string with_sensor(const std::string& inner) {
    return "<sensor type=\"perspective\">" + inner + "</sensor>";
}

}  // namespace plumb::testing_files
