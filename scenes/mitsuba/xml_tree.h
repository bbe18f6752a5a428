#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/description/place.h"

namespace plumb {

/// One element of a scene's files after includes and $names: plain data, independent of the parser.
struct XmlElement {
    std::string tag;
    std::map<std::string, std::string> attributes;
    std::vector<XmlElement> children;
    description::Place place;

    [[nodiscard]] bool has(const std::string& attribute) const { return attributes.contains(attribute); }
    /// The attribute's value. Throws an Error with the place where the attribute is missing.
    [[nodiscard]] const std::string& attribute(const std::string& name) const;
};

/// Values for $name in attributes: those of the command line go before the file's <default>.
using Definitions = std::map<std::string, std::string>;

/// The tree under <scene>, with <include filename="…"/> replaced by the children of the included <scene> and every
/// <default name="…" value="…"/> applied to what follows it. Throws Error with file and line for a missing or
/// malformed file, an include of itself, an undefined $name, and for a definition that nothing asks for.
XmlElement read_xml_tree(const std::filesystem::path& file, const Definitions& definitions);

}  // namespace plumb
