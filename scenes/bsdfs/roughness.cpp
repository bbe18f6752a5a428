#include "scenes/bsdfs/roughness.h"

#include <fmt/format.h>

namespace plumb::description {

namespace {

// Mitsuba's two roughnesses, or one; two that are equal are one.
double load_alpha(Properties& properties) {
    const double alpha = properties.number("alpha", 0.1);
    const double u = properties.number("alpha_u", 0.1), v = properties.number("alpha_v", 0.1);
    if (!properties.has("alpha_u") && !properties.has("alpha_v")) return alpha;
    if (properties.has("alpha"))
        throw properties.place_of("alpha").error("alpha is given, and alpha_u or alpha_v too; one way is accepted");
    if (u != v)
        properties.replaced(
            fmt::format("anisotropic roughness by alpha = {}", v),
            properties.place().error(fmt::format(
                "anisotropic roughness: alpha_u is {} and alpha_v {}; equal ones or the isotropic alpha are accepted",
                u, v)));
    return v;
}

}  // namespace

Roughness Roughness::load(Properties& properties) {
    const Place& place = properties.place();
    Roughness roughness;
    roughness.alpha = load_alpha(properties);
    if (!(roughness.alpha > 0))
        throw properties.place_of(properties.has("alpha_v") ? "alpha_v" : "alpha")
            .error(fmt::format("alpha is {}; roughness above 0 is accepted", roughness.alpha));
    const std::string distribution = keyword(properties, "distribution", "beckmann");
    if (distribution == "ggx") {
        roughness.distribution = Microfacets::ggx;
    } else if (distribution != "beckmann") {
        properties.replaced(fmt::format("distribution '{}' by beckmann", distribution),
                            place.error(unknown_name("distribution", distribution, {"beckmann", "ggx"}).what()));
    }
    return roughness;
}

}  // namespace plumb::description
