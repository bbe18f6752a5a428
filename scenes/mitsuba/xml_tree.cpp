#include "scenes/mitsuba/xml_tree.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

namespace plumb {

namespace fs = std::filesystem;
using description::Place;

const std::string& XmlElement::attribute(const std::string& name) const {
    reading.attributes.insert(name);
    const auto found = attributes.find(name);
    if (found == attributes.end()) throw place.error(fmt::format("<{}> without the attribute '{}'", tag, name));
    return found->second;
}

fs::path find_file(const std::string& name, const XmlElement& element, const fs::path& main) {
    const fs::path beside = fs::path(element.place.file).parent_path() / name, in_main = main / name;
    for (const fs::path& path : {beside, in_main})
        if (fs::is_regular_file(path)) return path;
    throw element.place.error(
        fmt::format("there is no file {}{}", beside.string(), beside == in_main ? "" : " nor " + in_main.string()));
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
    std::optional<int> version;
};

/// Throws an Error for an attribute that is none of these.
void accept_only(const XmlElement& element, const std::vector<std::string>& accepted) {
    for (const auto& [name, value] : element.attributes)
        if (std::ranges::find(accepted, name) == accepted.end())
            throw element.place.error(
                unknown_name(fmt::format("attribute of <{}>", element.tag), name, accepted).what());
}

/// The first number of a version: 0 of "0.6.0".
int parse_version(const std::string& text, const Place& place) {
    int version = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), version);
    if (code != std::errc{} || (end != text.data() + text.size() && *end != '.') || version < 0 || version > 3)
        throw place.error(fmt::format("a scene of version '{}'; 0.4.0 to 3.x are accepted", text));
    return version;
}

class TreeReader {
public:
    TreeReader(const Definitions& definitions, fs::path main) : values_(definitions), main_(std::move(main)) {
        for (const auto& [name, value] : definitions) fixed_.insert(name);
    }

    XmlElement read(const fs::path& path, const Place& from, std::optional<int> version) {
        if (std::ranges::find(stack_, fs::weakly_canonical(path)) != stack_.end()) {
            throw from.error(fmt::format("include of {}, which is being read already", path.string()));
        }
        std::ifstream stream(path, std::ios::binary);
        if (!stream || fs::is_directory(path)) {
            const std::string message = fmt::format("cannot read the scene file {}", path.string());
            throw from.line > 0 ? from.error(message) : Error(message);
        }
        std::string text(std::istreambuf_iterator<char>(stream), {});
        OpenFile file{path, Lines(text), version};
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
        if (const pugi::xml_attribute own = root.attribute("version")) file.version = parse_version(own.value(), place);
        stack_.push_back(fs::weakly_canonical(path));
        XmlElement tree = convert(root, file);
        stack_.pop_back();
        accept_only(tree, {"version"});
        tree.reading.attributes.insert("version");
        return tree;
    }

    /// The <default> elements that nothing asked for.
    [[nodiscard]] std::vector<XmlElement> unused() const {
        std::vector<XmlElement> result;
        for (const auto& [name, definition] : defaults_)
            if (!used_.contains(name)) result.push_back(definition.element);
        return result;
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
                           .place = {file.path.string(), file.lines.at(node.offset_debug())},
                           .version = file.version};
        if (depth > deepest)
            throw element.place.error(fmt::format("elements nested deeper than {}; that many are accepted", deepest));
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            if (!element.attributes.try_emplace(attribute.name(), substituted(attribute.value(), element.place)).second)
                throw element.place.error(
                    fmt::format("the attribute '{}' of <{}> is given twice", attribute.name(), element.tag));
        }
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                throw Place{file.path.string(), file.lines.at(child.offset_debug())}.error(
                    fmt::format("the text '{}' within <{}>; elements are accepted", child.value(), element.tag));
            if (child.type() == pugi::node_element) add(child, file, depth, element.children);
        }
        return element;
    }

    void add(const pugi::xml_node& node, const OpenFile& file, int depth, std::vector<XmlElement>& to) {
        XmlElement element = convert(node, file, depth + 1);
        if (element.tag == "default") {
            define(std::move(element), node.offset_debug());
        } else if (element.tag == "include") {
            accept_only(element, {"filename"});
            only_without_children(element);
            const fs::path included = included_file(element);
            std::ranges::move(read(included, element.place, file.version).children, std::back_inserter(to));
        } else {
            to.push_back(std::move(element));
        }
    }

    [[nodiscard]] fs::path included_file(const XmlElement& element) const {
        try {
            return find_file(element.attribute("filename"), element, main_);
        } catch (const Error&) {  // read() says what is the matter
            return fs::path(element.place.file).parent_path() / element.attribute("filename");
        }
    }

    static void only_without_children(const XmlElement& element) {
        if (!element.children.empty())
            throw element.children.front().place.error(
                fmt::format("<{}> within <{}>; nothing is accepted there", element.children.front().tag, element.tag));
    }

    // The first definition counts, so that a file can offer defaults to those that include it; twice in one file is a
    // mistake.
    void define(XmlElement element, std::ptrdiff_t offset) {
        accept_only(element, {"name", "value"});
        only_without_children(element);
        const std::string name = element.attribute("name");
        if (fixed_.contains(name)) used_.insert(name);
        values_.try_emplace(name, element.attribute("value"));
        const auto& before = defaults_.try_emplace(name, Definition{offset, element}).first->second;
        if (before.element.place.file == element.place.file && before.offset != offset)
            throw element.place.error(
                fmt::format("a second <default> of '{}'; the first is in line {}", name, before.element.place.line));
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

    struct Definition {
        std::ptrdiff_t offset;
        XmlElement element;
    };

    Definitions values_;
    fs::path main_;
    std::map<std::string, Definition> defaults_;
    std::set<std::string> fixed_, used_;
    std::vector<fs::path> stack_;
};

}  // namespace

XmlElement read_xml_tree(const fs::path& file, const Definitions& definitions) {
    TreeReader reader(definitions, file.parent_path());
    XmlElement tree = reader.read(file, {}, {});
    reader.check_all_used();
    std::ranges::move(reader.unused(), std::back_inserter(tree.children));
    return tree;
}

}  // namespace plumb
