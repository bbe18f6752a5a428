#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using description::AreaEmitter;
using description::Emitter;

AreaEmitter load_area_emitter(const XmlElement& element, Loader& loader) {
    if (!description::serves<AreaEmitter>(element.attribute("type"))) {
        throw element.place.error(
            fmt::format("emitter '{}' on a shape; 'area' is accepted there", element.attribute("type")));
    }
    XmlProperties properties(element, loader);
    AreaEmitter emitter = AreaEmitter::load(properties);
    properties.finish();
    return emitter;
}

Emitter load_emitter(const XmlElement& element, Loader& loader) {
    using Kind = decltype(Emitter::kind);
    XmlProperties properties(element, loader);
    std::optional<Kind> kind = load_model<Kind>(description::EmitterModels{}, properties);
    if (!kind && description::serves<AreaEmitter>(properties.type()))
        throw element.place.error(fmt::format("emitter '{}' outside a shape", properties.type()));
    if (!kind && (properties.type() == "sunsky" || properties.type() == "sky")) {
        properties.replaced(fmt::format("emitter '{}' by a constant sky of radiance 1", properties.type()),
                            loader.unknown_plugin(element));
        kind = description::ConstantSky{};
        element.reading.left_out = true;
    }
    if (!kind) throw loader.unknown_plugin(element);
    properties.finish();
    return {*std::move(kind), element.place};
}

}  // namespace plumb::mitsuba
