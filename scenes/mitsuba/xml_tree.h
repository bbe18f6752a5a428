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
    bool taken = false;        ///< somebody reads the element
    bool passed_over = false;  ///< it is left out with all that is in it, knowingly
    bool referred = false;     ///< a <ref> led to it
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

/// Values for $name in attributes: those of the command line go before the file's <default>.
using Definitions = std::map<std::string, std::string>;

/// The file of this name, looked up beside the element's file, then in the main scene's folder (Mitsuba knows the
/// second alone). Throws an Error naming the places where there is none.
std::filesystem::path find_file(const std::string& name, const XmlElement& element, const std::filesystem::path& main);

/// The tree under <scene>, with <include filename="…"/> replaced by the children of the included <scene> and every
/// <default name="…" value="…"/> applied to what follows it; those that nothing asks for stay at the tree's end. Throws
/// Error with file and line for a missing or malformed file, an include of itself, an undefined $name, text between
/// elements, an attribute given twice, and for a definition that nothing asks for.
XmlElement read_xml_tree(const std::filesystem::path& file, const Definitions& definitions);

}  // namespace plumb
