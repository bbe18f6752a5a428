#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scenes/mitsuba/xml_tree.h"

namespace plumb {

/// The values of $names: one of the command line goes before every <default>, the first <default> before later ones,
/// so that a file can offer defaults to those that include it.
class DefinedNames {
public:
    explicit DefinedNames(const Definitions& given);

    /// Takes a <default name="…" value="…"/>, which stands at this offset of its file. Throws Error for a second one of
    /// the name in one file.
    void define(const XmlElement& element, std::ptrdiff_t offset);
    /// The text with every $name replaced. Throws Error for a name without a value.
    std::string substituted(const std::string& text, const description::Place& place);

    /// Throws Error for a name of the command line that the scene neither asks for nor offers a default of.
    void check_given_used() const;
    /// The <default> elements that nothing asked for.
    [[nodiscard]] std::vector<XmlElement> unused() const;

private:
    struct Default {
        std::ptrdiff_t offset;
        XmlElement element;
    };

    Definitions given_, values_;
    std::map<std::string, Default> defaults_;
    std::set<std::string> used_;
};

}  // namespace plumb
