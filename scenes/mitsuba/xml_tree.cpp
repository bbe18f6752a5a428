#include "scenes/mitsuba/xml_tree.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace plumb {

namespace fs = std::filesystem;
using description::Place;

const std::string& XmlElement::attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    if (found == attributes.end()) throw place.error(fmt::format("<{}> without the attribute '{}'", tag, name));
    return found->second;
}

namespace {

/// Lines of a text by offset.
class Lines {
public:
    explicit Lines(const std::string& text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') ends_.push_back(static_cast<std::ptrdiff_t>(i));
        }
    }
    [[nodiscard]] int at(std::ptrdiff_t offset) const {
        return 1 + static_cast<int>(std::ranges::lower_bound(ends_, offset) - ends_.begin());
    }

private:
    std::vector<std::ptrdiff_t> ends_;
};

constexpr int deepest = 100;  // elements within elements: ours and whoever reads the tree go down by recursion

struct OpenFile {
    fs::path path;
    Lines lines;
};

class TreeReader {
public:
    explicit TreeReader(const Definitions& definitions) : values_(definitions) {
        for (const auto& [name, value] : definitions) fixed_.insert(name);
    }

    XmlElement read(const fs::path& path, const Place& from) {
        if (std::ranges::find(stack_, fs::weakly_canonical(path)) != stack_.end()) {
            throw from.error(fmt::format("include of {}, which is being read already", path.string()));
        }
        std::ifstream stream(path, std::ios::binary);
        if (!stream || fs::is_directory(path)) {
            const std::string message = fmt::format("cannot read the scene file {}", path.string());
            throw from.line > 0 ? from.error(message) : Error(message);
        }
        std::string text(std::istreambuf_iterator<char>(stream), {});
        const OpenFile file{path, Lines(text)};
        pugi::xml_document document;
        const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
        if (!parsed) {
            throw Place{path.string(), file.lines.at(parsed.offset)}.error(
                fmt::format("malformed XML: {}", parsed.description()));
        }
        const pugi::xml_node root = document.document_element();
        const Place place{path.string(), file.lines.at(root.offset_debug())};
        if (std::string_view(root.name()) != "scene") {
            throw place.error(fmt::format("the root element is <{}>; <scene> is accepted", root.name()));
        }
        stack_.push_back(fs::weakly_canonical(path));
        XmlElement tree = convert(root, file);
        stack_.pop_back();
        return tree;
    }

    void check_all_used() const {
        for (const std::string& name : fixed_) {
            if (!used_.contains(name)) throw Error(fmt::format("-D {}: nothing in the scene asks for ${}", name, name));
        }
    }

private:
    XmlElement convert(const pugi::xml_node& node, const OpenFile& file, int depth = 0) {
        XmlElement element{.tag = node.name(),
                           .attributes = {},
                           .children = {},
                           .place = {file.path.string(), file.lines.at(node.offset_debug())}};
        if (depth > deepest)
            throw element.place.error(fmt::format("elements nested deeper than {}; that many are accepted", deepest));
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            element.attributes[attribute.name()] = substituted(attribute.value(), element.place);
        }
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            XmlElement converted = convert(child, file, depth + 1);
            if (converted.tag == "default") {
                define(converted);
            } else if (converted.tag == "include") {
                const fs::path included = file.path.parent_path() / converted.attribute("filename");
                std::ranges::move(read(included, converted.place).children, std::back_inserter(element.children));
            } else {
                element.children.push_back(std::move(converted));
            }
        }
        return element;
    }

    void define(const XmlElement& element) {
        const std::string& name = element.attribute("name");
        if (fixed_.contains(name)) used_.insert(name);
        values_.try_emplace(name, element.attribute("value"));
    }

    std::string substituted(const std::string& text, const Place& place) {
        std::string result;
        for (std::size_t i = 0; i < text.size();) {
            if (text[i] != '$') {
                result += text[i++];
                continue;
            }
            std::size_t end = i + 1;
            while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
                ++end;
            const std::string name = text.substr(i + 1, end - i - 1);
            const auto found = values_.find(name);
            if (found == values_.end()) {
                throw place.error(fmt::format("${} has no value; give -D {}=… or a <default> before it", name, name));
            }
            used_.insert(name);
            result += found->second;
            i = end;
        }
        return result;
    }

    Definitions values_;
    std::set<std::string> fixed_, used_;
    std::vector<fs::path> stack_;
};

}  // namespace

XmlElement read_xml_tree(const fs::path& file, const Definitions& definitions) {
    TreeReader reader(definitions);
    XmlElement tree = reader.read(file, {});
    reader.check_all_used();
    return tree;
}

}  // namespace plumb
