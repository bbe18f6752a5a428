#include "scenes/mitsuba/defined_names.h"

#include <cctype>

#include <fmt/format.h>

namespace plumb {

using description::Place;

DefinedNames::DefinedNames(const Definitions& given) : given_(given), values_(given) {}

void DefinedNames::define(const XmlElement& element, std::ptrdiff_t offset) {
    const std::string& name = element.attribute("name");
    values_.try_emplace(name, element.attribute("value"));
    const Default& first = defaults_.try_emplace(name, Default{offset, element}).first->second;
    if (first.element.place.file == element.place.file && first.offset != offset)
        throw element.place.error(
            fmt::format("a second <default> of '{}'; the first is in line {}", name, first.element.place.line));
}

std::string DefinedNames::substituted(const std::string& text, const Place& place) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] != '$') {
            result += text[i++];
            continue;
        }
        std::size_t end = i + 1;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
        const std::string name = text.substr(i + 1, end - i - 1);
        const auto found = values_.find(name);
        if (found == values_.end())
            throw place.error(fmt::format("${} has no value; give -D {}=… or a <default> before it", name, name));
        used_.insert(name);
        result += found->second;
        i = end;
    }
    return result;
}

void DefinedNames::check_given_used() const {
    for (const auto& [name, value] : given_)
        if (!used_.contains(name) && !defaults_.contains(name))
            throw Error(fmt::format("-D {}: nothing in the scene asks for ${}", name, name));
}

std::vector<XmlElement> DefinedNames::unused() const {
    std::vector<XmlElement> result;
    for (const auto& [name, definition] : defaults_)
        if (!used_.contains(name)) result.push_back(definition.element);
    return result;
}

}  // namespace plumb
