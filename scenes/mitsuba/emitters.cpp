#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using namespace description;

AreaEmitter load_area_emitter(const XmlElement& element, Loader& loader) {
    if (element.attribute("type") != "area") {
        throw element.place.error(
            fmt::format("emitter '{}' on a shape; 'area' is accepted there", element.attribute("type")));
    }
    Properties properties(element, loader);
    AreaEmitter emitter{.radiance = properties.spectrum("radiance", Spectrum::grey(1), true), .place = element.place};
    properties.finish();
    return emitter;
}

Emitter load_emitter(const XmlElement& element, Loader& loader) {
    Properties properties(element, loader);
    Emitter emitter{.kind = ConstantSky{}, .place = element.place};
    const std::string& type = element.attribute("type");
    properties.number("sampling_weight", 1);
    if (type == "constant") {
        emitter.kind = ConstantSky{properties.spectrum("radiance", Spectrum::grey(1), true)};
    } else if (type == "envmap") {
        const double scale = properties.number("scale", 1);
        if (!(scale >= 0))
            throw properties.place_of("scale").error(fmt::format("scale is {}; values from 0 are accepted", scale));
        emitter.kind = EnvironmentMap{properties.file("filename"), scale, properties.transform("to_world")};
    } else if (type == "point") {
        const Vec3 position = properties.vector("position", {});
        emitter.kind = PointLight{properties.transform("to_world").point(position),
                                  properties.spectrum("intensity", Spectrum::grey(1), true)};
    } else if (type == "area") {
        throw element.place.error("emitter 'area' outside a shape");
    } else {
        throw loader.unknown_plugin(element);
    }
    properties.finish();
    return emitter;
}

}  // namespace plumb::mitsuba
