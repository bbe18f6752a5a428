#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

namespace {

using Names = std::array<std::string_view, 2>;

// Mitsuba's name and ours.
constexpr std::array<Names, 4> shared_integrators{
    {{"bdpt", "bdpt"}, {"direct", "direct"}, {"path", "path"}, {"ptracer", "light"}}};

/// Takes all values of an element whose names are not known, and the integrators and samplers within it.
void take_anything(const XmlElement& element) {
    for (const XmlElement& child : element.children) {
        if (child.tag == "integrator" || child.tag == "sampler") {
            child.reading.taken = true;
            for (const char* attribute : {"type", "id", "name"}) child.reading.attributes.insert(attribute);
            take_anything(child);
        } else if (is_value(child.tag) && child.has("name")) {
            child.reading.taken = true;
            static_cast<void>(child.attribute("value"));
        }
    }
}

/// A number of edges, if the file has it.
std::optional<int> edges(XmlProperties& properties, const std::string& name, int least) {
    const int value = properties.integer(name, least);
    if (!properties.has(name)) return {};
    if (value < least)
        throw properties.place_of(name).error(
            fmt::format("{} is {}; whole numbers from {} are accepted", name, value, least));
    return value;
}

}  // namespace

std::optional<description::Integrator> load_integrator(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    const auto found =
        std::ranges::find(shared_integrators, properties.type(), [](const Names& names) { return names[0]; });
    std::optional<description::Integrator> integrator;
    if (found != shared_integrators.end()) {
        integrator = description::Integrator{.name = std::string((*found)[1])};
        if (integrator->name != "direct") {  // which has one length
            integrator->longest = edges(properties, "max_depth", -1);
            integrator->roulette_at = edges(properties, "rr_depth", 0);
        }
    } else {
        loader.ignored(element.place, fmt::format("integrator '{}'", properties.type()));
        take_anything(element);
    }
    properties.finish();
    return integrator;
}

void pass_over_sampler(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    loader.ignored(element.place, fmt::format("sampler '{}'", properties.type()));
    for (const std::string& name : names_without_effect(element.tag)) properties.pass_over(name);
    properties.finish();
}

}  // namespace plumb::mitsuba
