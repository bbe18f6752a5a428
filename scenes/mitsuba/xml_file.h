#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "scenes/description/place.h"

namespace plumb {

/// One file of a scene, parsed; its elements live as long as it does.
class XmlFile {
public:
    /// Throws Error for a file that cannot be read, is no XML or has anything but comments beside its root element.
    /// `from`: the place that names the file; without a line for the main one.
    XmlFile(std::filesystem::path path, const description::Place& from);

    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    [[nodiscard]] description::Place place(const pugi::xml_node& node) const { return at(node.offset_debug()); }

private:
    [[nodiscard]] description::Place at(std::ptrdiff_t offset) const;
    void accept_one_root() const;

    std::filesystem::path path_;
    std::vector<std::ptrdiff_t> line_ends_;
    pugi::xml_document document_;
};

}  // namespace plumb
