#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scenes/description/place.h"

namespace plumb {

/// What a loader asked of an element, whether or not the element has it: what else it has is read by nobody.
struct Reading {
    bool taken = false;     ///< somebody reads the element
    bool left_out = false;  ///< nobody reads it nor what is in it, and a note says so
    std::set<std::string> attributes = {};
    std::set<std::string> names = {};  ///< of children with a name
    std::set<std::string> parts = {};  ///< tags of children that need none
};

/// One element of a scene's files after includes and $names, independent of the parser. It keeps account of what is
/// asked of it.
struct XmlElement {
    std::string tag;
    std::map<std::string, std::string> attributes;
    std::vector<XmlElement> children;
    description::Place place;
    std::optional<int> version = {};  ///< the first number of its file's, else of the including file's
    mutable Reading reading = {};

    [[nodiscard]] bool has(const std::string& attribute) const {
        reading.attributes.insert(attribute);
        return attributes.contains(attribute);
    }
    /// The attribute's value. Throws an Error with the place where the attribute is missing.
    [[nodiscard]] const std::string& attribute(const std::string& name) const;
};

/// Folders in which files are looked up, the first ones first.
using Folders = std::vector<std::filesystem::path>;

/// The file of this name, looked up beside the file that names it, then in the folders. Throws an Error with the place
/// that lists where it was looked for.
std::filesystem::path find_file(const std::string& name, const description::Place& place, const Folders& folders);

/// Values for $name in attributes: those of the command line go before the file's <default>.
using Definitions = std::map<std::string, std::string>;

/// A scene's files as one tree.
struct XmlTree {
    XmlElement root;                       ///< <scene>
    Folders folders;                       ///< of <path value="…"/>, the last one first, and of the main file
    std::vector<XmlElement> unused_names;  ///< <default> elements that nothing asked for
};

/// The tree of a file, with <include filename="…"/> replaced by the included file's element, or by the children of its
/// <scene>, and every <default name="…" value="…"/> applied to what follows it. Throws Error with file and line for a
/// missing or malformed file, an include of itself, an undefined $name, text between elements, an attribute given
/// twice, and for a definition that nothing asks for.
XmlTree read_xml_tree(const std::filesystem::path& file, const Definitions& definitions);

}  // namespace plumb
