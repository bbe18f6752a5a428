#include <fmt/format.h>

#include "scenes/mitsuba_loader.h"

namespace plumb::mitsuba {

using namespace description;

namespace {

Spectrum emission(Properties& properties, const std::string& name) {
    const Spectrum value = properties.spectrum(name, Spectrum::grey(1), true);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(value[i] >= 0)) {
            throw properties.element().place.error(fmt::format("{} is {}; values from 0 are accepted", name, value[i]));
        }
    }
    return value;
}

}  // namespace

AreaEmitter load_area_emitter(const XmlElement& element, Loader& loader) {
    if (element.attribute("type") != "area") {
        throw element.place.error(
            fmt::format("emitter '{}' on a shape; 'area' is accepted there", element.attribute("type")));
    }
    Properties properties(element, loader);
    AreaEmitter emitter{.radiance = emission(properties, "radiance"), .place = element.place};
    properties.finish();
    return emitter;
}

Emitter load_emitter(const XmlElement& element, Loader& loader) {
    Properties properties(element, loader);
    Emitter emitter{.kind = ConstantSky{}, .place = element.place};
    const std::string& type = element.attribute("type");
    properties.number("sampling_weight", 1);
    if (type == "constant") {
        emitter.kind = ConstantSky{emission(properties, "radiance")};
    } else if (type == "envmap") {
        const double scale = properties.number("scale", 1);
        if (!(scale >= 0)) throw element.place.error(fmt::format("scale is {}; values from 0 are accepted", scale));
        emitter.kind = EnvironmentMap{properties.file("filename"), scale, properties.transform("to_world")};
    } else if (type == "point") {
        const Vec3 position = properties.vector("position", {});
        emitter.kind = PointLight{properties.transform("to_world").point(position), emission(properties, "intensity")};
    } else if (type == "area") {
        throw element.place.error("emitter 'area' outside a shape");
    } else {
        throw loader.unknown_plugin(element);
    }
    properties.finish();
    return emitter;
}

}  // namespace plumb::mitsuba
