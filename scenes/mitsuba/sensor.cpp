#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using namespace description;

namespace {

Filter load_filter(const XmlElement& element, Loader& loader) {
    Properties properties(element, loader);
    const std::string& type = element.attribute("type");
    Filter filter;
    if (type == "box") {
        filter = {FilterKind::box, properties.number("radius", 0.5), 0};
    } else if (type == "tent") {
        filter = {FilterKind::tent, properties.number("radius", 1), 0};
    } else {
        if (type != "gaussian") {
            loader.replaced(element.place, fmt::format("rfilter '{}' by gaussian", type),
                            loader.unknown_plugin(element));
        }
        const double stddev = type == "gaussian" ? properties.number("stddev", 0.5) : 0.5;
        filter = {FilterKind::gaussian, 4 * stddev, stddev};  // cut off where Mitsuba cuts it
    }
    if (!(filter.radius > 0))
        throw element.place.error(fmt::format("a filter of radius {}; above 0 is accepted", filter.radius));
    properties.finish(type != "gaussian" && type != "box" && type != "tent");
    return filter;
}

Film load_film(const XmlElement& element, Loader& loader) {
    Properties properties(element, loader);
    Film film{.width = properties.integer("width", 768), .height = properties.integer("height", 576), .filter = {}};
    if (film.width < 1 || film.height < 1 || film.width > 65536 || film.height > 65536) {
        throw element.place.error(
            fmt::format("a film of {}×{}; 1 to 65536 pixels a side are accepted", film.width, film.height));
    }
    for (const XmlElement& child : element.children) {
        if (child.tag == "rfilter") film.filter = load_filter(child, loader);
    }
    if (const std::string& type = element.attribute("type"); type != "hdrfilm") {
        loader.ignored(element.place, fmt::format("film type '{}'; hdrfilm is taken", type));
    }
    properties.finish(true);
    return film;
}

/// The horizontal angle, from what the file gives along the axis it names.
double horizontal_fov(Properties& properties, const Film& film) {
    const Place& place = properties.element().place;
    const double width = film.width, height = film.height, degree = std::numbers::pi / 180;
    double fov = properties.number("fov", 0);
    std::string axis = properties.string("fov_axis", "x");
    const std::string focal = properties.string("focal_length", "50mm");
    if (!properties.has("fov")) {
        // Of a 35 mm camera, whose frame measures 36 × 24 mm.
        const std::string digits = focal.ends_with("mm") ? focal.substr(0, focal.size() - 2) : focal;
        fov = 2 * std::atan(std::hypot(36.0, 24.0) / (2 * parse_number(digits, place))) / degree;
        axis = "diagonal";
    }
    if (!(fov > 0 && fov < 180))
        throw properties.place_of("fov").error(
            fmt::format("fov is {}; angles between 0 and 180 degrees are accepted", fov));
    double side = 0;
    if (axis == "x")
        side = width;
    else if (axis == "y")
        side = height;
    else if (axis == "diagonal")
        side = std::hypot(width, height);
    else if (axis == "smaller")
        side = std::min(width, height);
    else if (axis == "larger")
        side = std::max(width, height);
    else
        throw place.error(unknown_name("fov_axis", axis, {"x", "y", "diagonal", "smaller", "larger"}).what());
    return 2 * std::atan(std::tan(fov * degree / 2) * width / side) / degree;
}

}  // namespace

Sensor load_sensor(const XmlElement& element, Loader& loader) {
    const std::string& type = element.attribute("type");
    if (type != "perspective" && type != "thinlens") throw loader.unknown_plugin(element);
    Properties properties(element, loader);
    Sensor sensor;
    sensor.to_world = properties.transform("to_world");
    sensor.place = element.place;
    for (const XmlElement& child : element.children) {
        if (child.tag == "film")
            sensor.film = load_film(child, loader);
        else if (child.tag == "sampler")
            loader.ignored(child.place, fmt::format("sampler '{}'", child.attribute("type")));
    }
    sensor.fov_x = horizontal_fov(properties, sensor.film);
    if (type == "thinlens") {
        sensor.aperture_radius = properties.number("aperture_radius", 0);
        sensor.focus_distance = properties.number("focus_distance", 1);
        if (!(sensor.aperture_radius >= 0)) {
            throw properties.place_of("aperture_radius")
                .error(fmt::format("aperture_radius is {}; values from 0 are accepted", sensor.aperture_radius));
        }
        if (!(sensor.focus_distance > 0)) {
            throw properties.place_of("focus_distance")
                .error(fmt::format("focus_distance is {}; values above 0 are accepted", sensor.focus_distance));
        }
    }
    properties.finish(true);
    return sensor;
}

}  // namespace plumb::mitsuba
