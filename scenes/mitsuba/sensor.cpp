#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using description::Film;
using description::Sensor;

namespace {

Filter load_filter(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    const std::optional<Filter> filter = load_model<Filter>(FilterModels{}, properties);
    if (!filter) {
        properties.replaced(fmt::format("rfilter '{}' by gaussian", properties.type()), loader.unknown_plugin(element));
        element.reading.left_out = true;
    }
    properties.finish();
    return filter.value_or(GaussianFilter());
}

Film load_film(const XmlElement& element, Loader& loader) {
    XmlProperties properties(element, loader);
    Film film = Film::load(properties);
    if (const XmlElement* filter = properties.part("rfilter")) film.filter = load_filter(*filter, loader);
    if (!description::serves<Film>(properties.type()))
        properties.ignored(fmt::format("film type '{}'; hdrfilm is taken", properties.type()));
    properties.finish();
    return film;
}

}  // namespace

Sensor load_sensor(const XmlElement& element, Loader& loader) {
    using Kind = decltype(Sensor::kind);
    XmlProperties properties(element, loader);
    Sensor sensor{.to_world = properties.transform("to_world"), .kind = {}, .film = {}, .place = element.place};
    if (const XmlElement* film = properties.part("film")) sensor.film = load_film(*film, loader);
    if (const XmlElement* sampler = properties.part("sampler")) pass_over_sampler(*sampler, loader);
    std::optional<Kind> kind = load_model<Kind>(description::SensorModels{}, properties, sensor.film);
    if (!kind) throw loader.unknown_plugin(element);
    sensor.kind = *std::move(kind);
    properties.finish();
    return sensor;
}

Sensor default_sensor(const XmlElement& scene, Loader& loader) {
    constexpr double fov = 45;
    Sensor sensor{.to_world = {}, .kind = description::Perspective{.fov_x = fov}, .film = {}, .place = scene.place};
    Vec3 from;
    if (!loader.scene.shapes.empty()) {
        Box box;
        for (const description::Shape& shape : loader.scene.shapes) box.add(bounds(shape.geometry));
        const Vec3 sides = box.high - box.low, centre = (box.low + box.high) / 2;
        const double distance =
            std::max({sides.x, sides.y, sides.z}) / (2 * std::tan(fov / 2 * std::numbers::pi / 180));
        from = {centre.x, centre.y, box.low.z - distance};
    }
    sensor.to_world = Transform::translate(from);
    loader.scene.notes.push_back({description::Note::Kind::replaced, scene.place,
                                  fmt::format("no <sensor> by a perspective one of {} degrees at {:.4g} {:.4g} {:.4g}, "
                                              "which looks along +z",
                                              fov, from.x, from.y, from.z)});
    return sensor;
}

}  // namespace plumb::mitsuba
