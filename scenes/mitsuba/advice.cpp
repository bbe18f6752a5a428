#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

namespace {

// Those that Plumb has too. Others may hold what they like, nested integrators included.
constexpr std::array known_integrators{"bdpt", "direct", "path", "ptracer"};

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

}  // namespace

void pass_over(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    loader.ignored(element.place, fmt::format("{} '{}'", element.tag, properties.type()));
    if (element.tag == "integrator" &&
        std::ranges::find(known_integrators, properties.type()) == known_integrators.end())
        take_anything(element);
    else
        for (const std::string& name : names_without_effect(element.tag)) properties.pass_over(name);
    properties.finish();
}

}  // namespace plumb::mitsuba
