#include "scenes/sensors/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::description {

Film Film::load(Properties& properties) {
    Film film;
    film.width = properties.integer("width", film.width);
    film.height = properties.integer("height", film.height);
    if (film.width < 1 || film.height < 1 || film.width > 65536 || film.height > 65536) {
        throw properties.place().error(
            fmt::format("a film of {}×{}; 1 to 65536 pixels a side are accepted", film.width, film.height));
    }
    return film;
}

double load_fov_x(Properties& properties, const Film& film) {
    const Place& place = properties.place();
    const double width = film.width, height = film.height, degree = std::numbers::pi / 180;
    double fov = properties.number("fov", 0);
    std::string axis = keyword(properties, "fov_axis", "x");
    const std::string focal = properties.string("focal_length", "50mm");
    if (properties.has("focal_length") && (properties.has("fov") || properties.has("fov_axis")))
        throw properties.place_of("focal_length")
            .error("focal_length is given, and fov or fov_axis too; one way is accepted");
    if (properties.has("fov_axis") && !properties.has("fov"))
        throw properties.place_of("fov_axis").error("fov_axis is given without fov; both together are accepted");
    if (!properties.has("fov")) {
        // The angle is that of a 35 mm camera, whose frame measures 36 × 24 mm.
        const std::string digits = focal.ends_with("mm") ? focal.substr(0, focal.size() - 2) : focal;
        fov = 2 * std::atan(std::hypot(36.0, 24.0) / (2 * parse_number(digits, properties.place_of("focal_length")))) /
              degree;
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

}  // namespace plumb::description
