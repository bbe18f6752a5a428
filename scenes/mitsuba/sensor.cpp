#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using description::Film;
using description::Sensor;

namespace {

Filter load_filter(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    const std::optional<Filter> filter = load_model<Filter>(FilterModels{}, properties);
    if (!filter)
        properties.replaced(fmt::format("rfilter '{}' by gaussian", properties.type()), loader.unknown_plugin(element));
    properties.finish(!filter);
    return filter.value_or(GaussianFilter());
}

Film load_film(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    Film film = Film::load(properties);
    for (const XmlElement& child : element.children) {
        if (child.tag == "rfilter") film.filter = load_filter(child, loader);
    }
    if (!description::serves<Film>(properties.type()))
        properties.ignored(fmt::format("film type '{}'; hdrfilm is taken", properties.type()));
    properties.finish(true);
    return film;
}

}  // namespace

Sensor load_sensor(const XmlElement& element, Loader& loader) {
    using Kind = decltype(Sensor::kind);
    XmlProperties properties(element, loader);
    Sensor sensor{.to_world = properties.transform("to_world"), .kind = {}, .film = {}, .place = element.place};
    for (const XmlElement& child : element.children) {
        if (child.tag == "film")
            sensor.film = load_film(child, loader);
        else if (child.tag == "sampler")
            loader.ignored(child.place, fmt::format("sampler '{}'", child.attribute("type")));
    }
    std::optional<Kind> kind = load_model<Kind>(description::SensorModels{}, properties, sensor.film);
    if (!kind) throw loader.unknown_plugin(element);
    sensor.kind = *std::move(kind);
    properties.finish(true);
    return sensor;
}

}  // namespace plumb::mitsuba
