#include "scenes/mitsuba/xml_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

namespace plumb {

namespace fs = std::filesystem;
using description::Place;

XmlFile::XmlFile(fs::path path, const Place& from) : path_(std::move(path)) {
    std::ifstream stream(path_, std::ios::binary);
    if (!stream || fs::is_directory(path_)) {
        const std::string message = fmt::format("cannot read the scene file {}", path_.string());
        throw from.line > 0 ? from.error(message) : Error(message);
    }
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') line_ends_.push_back(static_cast<std::ptrdiff_t>(i));
    // As a fragment, so that the parser keeps what stands beside the root, for us to refuse.
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_fragment);
    if (!parsed) throw at(parsed.offset).error(fmt::format("malformed XML: {}", parsed.description()));
    accept_one_root();
}

Place XmlFile::at(std::ptrdiff_t offset) const {
    return {path_.string(), 1 + static_cast<int>(std::ranges::lower_bound(line_ends_, offset) - line_ends_.begin())};
}

void XmlFile::accept_one_root() const {
    if (!root()) throw at(0).error("no element; <scene> is accepted");
    for (const pugi::xml_node& node : document_.children()) {
        if (node.type() == pugi::node_element && node != root())
            throw place(node).error(
                fmt::format("<{}> after the end of <{}>; one root element is accepted", node.name(), root().name()));
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata)
            throw place(node).error(
                fmt::format("the text '{}' beside <{}>; one root element is accepted", node.value(), root().name()));
    }
}

}  // namespace plumb
