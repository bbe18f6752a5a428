// Ids, and what refers to them.

#include <algorithm>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

const XmlElement& Loader::resolve(const XmlElement& element) const {
    if (element.tag != "ref") return element;
    const std::string& id = element.attribute("id");
    const auto found = named.find(id);
    if (found != named.end()) return *found->second;
    std::vector<std::string> known;
    for (const auto& [other, target] : named) known.push_back(other);
    const std::string near = nearest_name(id, known);
    throw element.place.error(fmt::format("<ref> to '{}', but nothing has this id{}", id,
                                          near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

std::string as_seen_from(const description::Place& place, const description::Place& from) {
    return place.file == from.file ? fmt::format("line {}", place.line) : fmt::format("{}:{}", place.file, place.line);
}

namespace {

void index_ids(const XmlElement& element, Loader& loader) {
    for (const XmlElement& child : element.children) {
        index_ids(child, loader);
        // Whether an id is accepted is up to whoever reads the element.
        const auto id = child.attributes.find("id");
        if (id == child.attributes.end()) continue;
        if (child.tag == "ref" || child.tag == "alias") {
            loader.referred.insert(id->second);
            continue;
        }
        const auto [found, is_new] = loader.named.try_emplace(id->second, &child);
        if (!is_new)
            throw child.place.error(
                fmt::format("the id '{}' is taken by {}", id->second, as_seen_from(found->second->place, child.place)));
    }
}

// <alias id="a" as="b"/>: b is another name of a.
void index_aliases(const XmlElement& root, Loader& loader) {
    for (const XmlElement& child : root.children) {
        if (child.tag != "alias") continue;
        const auto found = loader.named.find(child.attribute("id"));
        if (found == loader.named.end())
            throw child.place.error(fmt::format("<alias> of '{}', but nothing has this id", child.attribute("id")));
        if (!loader.named.try_emplace(child.attribute("as"), found->second).second)
            throw child.place.error(fmt::format("the id '{}' is taken", child.attribute("as")));
        child.reading.taken = true;
    }
}

bool is_referred_into(const XmlElement& element, const Loader& loader) {
    const auto id = element.attributes.find("id");
    return (id != element.attributes.end() && loader.referred.contains(id->second)) ||
           std::ranges::any_of(element.children, [&](const auto& child) { return is_referred_into(child, loader); });
}

}  // namespace

void index_references(const XmlElement& root, Loader& loader) {
    index_ids(root, loader);
    index_aliases(root, loader);
}

void report_unreferred(const XmlElement& root, Loader& loader) {
    for (const XmlElement& child : root.children) {
        if (child.tag != "bsdf" && child.tag != "texture") continue;
        const std::string what = fmt::format("{} '{}'", child.tag, child.attribute("type"));
        const std::string id = child.has("id") ? child.attribute("id") : "";
        if (loader.referred.contains(id)) continue;
        if (is_referred_into(child, loader))
            loader.ignored(child.place, fmt::format("{}: a <ref> leads to what is within, none to it", what));
        else if (!id.empty())
            loader.ignored(child.place, fmt::format("{}: no <ref> to '{}'", what, id));
        else
            loader.replaced(
                child.place, fmt::format("{} by its absence", what),
                child.place.error(fmt::format("{} at the root without an id, so that nothing can refer to it; "
                                              "an id, or a place within what uses it, is accepted",
                                              what)));
    }
}

}  // namespace plumb::mitsuba
