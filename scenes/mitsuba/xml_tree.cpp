#include "scenes/mitsuba/xml_tree.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenes/mitsuba/defined_names.h"
#include "scenes/mitsuba/xml_file.h"

namespace plumb {

namespace fs = std::filesystem;
using description::Place;

const std::string& XmlElement::attribute(const std::string& name) const {
    reading.attributes.insert(name);
    const auto found = attributes.find(name);
    if (found != attributes.end()) return found->second;
    std::vector<std::string> given;
    for (const auto& [other, value] : attributes) given.push_back(fmt::format("'{}'", other));
    throw place.error(fmt::format("<{}> without the attribute '{}'{}{}", tag, name, given.empty() ? "" : "; it has ",
                                  fmt::join(given, ", ")));
}

fs::path find_file(const std::string& name, const Place& place, const Folders& folders) {
    std::vector<std::string> tried;
    const auto is_here = [&](const fs::path& path) {
        if (std::ranges::find(tried, path.string()) == tried.end()) tried.push_back(path.string());
        return fs::is_regular_file(path);
    };
    if (const fs::path beside = fs::path(place.file).parent_path() / name; is_here(beside)) return beside;
    for (const fs::path& folder : folders)
        if (is_here(folder / name)) return folder / name;
    throw place.error(fmt::format("there is no file {}", fmt::join(tried, " nor ")));
}

namespace {

constexpr int deepest = 100;  // elements within elements: ours and whoever reads the tree go down by recursion

/// Throws an Error for an attribute that is none of these, and for whatever stands within the element.
void accept_only(const XmlElement& element, const std::vector<std::string>& accepted) {
    for (const auto& [name, value] : element.attributes)
        if (std::ranges::find(accepted, name) == accepted.end())
            throw element.place.error(
                unknown_name(fmt::format("attribute of <{}>", element.tag), name, accepted).what());
    if (!element.children.empty())
        throw element.children.front().place.error(
            fmt::format("<{}> within <{}>; nothing is accepted there", element.children.front().tag, element.tag));
}

/// The first number of a version: 0 of "0.6.0". Before 0.4 cameras were of another handedness and name.
int parse_version(const std::string& text, const Place& place) {
    const char* const end = text.data() + text.size();
    int first = -1, second = 0;
    auto read = std::from_chars(text.data(), end, first);
    if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '.')
        read = std::from_chars(read.ptr + 1, end, second);
    if (read.ec != std::errc{} || (read.ptr != end && *read.ptr != '.') || first < 0 || first > 3 ||
        (first == 0 && second < 4))
        throw place.error(fmt::format("a scene of version '{}'; 0.4.0 to 3.x are accepted", text));
    return first;
}

class TreeReader {
public:
    TreeReader(const fs::path& main, const Definitions& definitions)
        : names_(definitions), folders_{main.parent_path()} {}

    XmlElement read_main(const fs::path& path) {
        XmlElement root = read(path, {}, {});
        if (root.tag != "scene")
            throw root.place.error(fmt::format("the root element is <{}>; <scene> is accepted", root.tag));
        names_.check_given_used();
        return root;
    }
    [[nodiscard]] const Folders& folders() const { return folders_; }
    [[nodiscard]] const DefinedNames& names() const { return names_; }

private:
    struct Open {
        const XmlFile& file;
        std::optional<int> version;
    };

    /// `version`: of the file that includes this one.
    XmlElement read(const fs::path& path, const Place& from, std::optional<int> version) {
        if (std::ranges::find(stack_, fs::weakly_canonical(path)) != stack_.end())
            throw from.error(fmt::format("include of {}, which is being read already", path.string()));
        const XmlFile file(path, from);
        if (const pugi::xml_attribute own = file.root().attribute("version"))
            version = parse_version(own.value(), file.place(file.root()));
        stack_.push_back(fs::weakly_canonical(path));
        XmlElement root = convert(file.root(), {file, version}, 0);
        stack_.pop_back();
        root.reading.attributes.insert("version");
        return root;
    }

    XmlElement convert(const pugi::xml_node& node, const Open& in, int depth) {
        XmlElement element{
            .tag = node.name(), .attributes = {}, .children = {}, .place = in.file.place(node), .version = in.version};
        if (depth > deepest)
            throw element.place.error(fmt::format("elements nested deeper than {}; that many are accepted", deepest));
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            std::string value = names_.substituted(attribute.value(), element.place);
            if (!element.attributes.try_emplace(attribute.name(), std::move(value)).second)
                throw element.place.error(
                    fmt::format("the attribute '{}' of <{}> is given twice", attribute.name(), element.tag));
        }
        for (const pugi::xml_node& child : node.children()) {
            if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
                throw in.file.place(child).error(
                    fmt::format("the text '{}' within <{}>; values stand in attributes", child.value(), element.tag));
            if (child.type() == pugi::node_element) add(child, in, depth, element);
        }
        return element;
    }

    /// Adds what the node means to its parent: itself, or what it tells the reader of files.
    void add(const pugi::xml_node& node, const Open& in, int depth, XmlElement& parent) {
        XmlElement element = convert(node, in, depth + 1);
        if (element.tag == "default") {
            accept_only(element, {"name", "value"});
            names_.define(element, node.offset_debug());
        } else if (element.tag == "include") {
            accept_only(element, {"filename"});
            include(element, in, parent);
        } else if (element.tag == "path") {
            accept_only(element, {"value"});
            if (depth > 0)
                throw element.place.error(fmt::format("<path> within <{}>; its place is in <scene>", parent.tag));
            folders_.insert(folders_.begin(), find_folder(element));
        } else {
            parent.children.push_back(std::move(element));
        }
    }

    void include(const XmlElement& element, const Open& in, XmlElement& parent) {
        const fs::path path = find_file(element.attribute("filename"), element.place, folders_);
        XmlElement root = read(path, element.place, in.version);
        if (root.tag != "scene") {
            root.attributes.erase("version");
            parent.children.push_back(std::move(root));
            return;
        }
        for (const auto& [name, value] : root.attributes)
            if (name != "version")
                throw root.place.error(unknown_name("attribute of <scene>", name, {"version"}).what());
        std::ranges::move(root.children, std::back_inserter(parent.children));
    }

    [[nodiscard]] fs::path find_folder(const XmlElement& element) const {
        const std::string& name = element.attribute("value");
        const fs::path beside = fs::path(element.place.file).parent_path() / name;
        if (fs::is_directory(beside)) return beside;
        for (const fs::path& folder : folders_)
            if (fs::is_directory(folder / name)) return folder / name;
        throw element.place.error(fmt::format("there is no folder {}", beside.string()));
    }

    DefinedNames names_;
    Folders folders_;
    std::vector<fs::path> stack_;
};

}  // namespace

XmlTree read_xml_tree(const fs::path& file, const Definitions& definitions) {
    TreeReader reader(file, definitions);
    XmlElement root = reader.read_main(file);
    return {std::move(root), reader.folders(), reader.names().unused()};
}

}  // namespace plumb
