#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scenes/geometry/ball.h"
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
        element.reading.passed_over = true;
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
    if (const XmlElement* sampler = properties.part("sampler")) pass_over(*sampler, loader);
    std::optional<Kind> kind = load_model<Kind>(description::SensorModels{}, properties, sensor.film);
    if (!kind) throw loader.unknown_plugin(element);
    sensor.kind = *std::move(kind);
    properties.finish();
    return sensor;
}

Sensor default_sensor(const XmlElement& scene, Loader& loader) {
    const Ball all = ball_around(loader.scene.shapes);
    Sensor sensor{.to_world = {}, .kind = description::Perspective{.fov_x = 45}, .film = {}, .place = scene.place};
    // A ball is within a cone of this half angle, that of the film's shorter side, from radius / sin of it.
    const double across = std::tan(std::numbers::pi / 8) * sensor.film.height / sensor.film.width;
    const Vec3 from = all.centre - Vec3{0, 0, all.radius / std::sin(std::atan(across))};
    sensor.to_world = Transform::translate(from);
    loader.scene.notes.push_back({description::Note::Kind::replaced, scene.place,
                                  fmt::format("no <sensor> by a perspective one of 45 degrees at {:.4g} {:.4g} {:.4g}, "
                                              "which looks along +z at all shapes",
                                              from.x, from.y, from.z)});
    return sensor;
}

}  // namespace plumb::mitsuba
