#include "scenes/bsdfs/roughness.h"

#include <fmt/format.h>

namespace plumb::description {

Roughness Roughness::load(Properties& properties) {
    const Place& place = properties.place();
    Roughness roughness;
    roughness.alpha = properties.number("alpha", 0.1);
    if (!(roughness.alpha > 0))
        throw properties.place_of("alpha").error(
            fmt::format("alpha is {}; roughness above 0 is accepted", roughness.alpha));
    for (const char* name : {"alpha_u", "alpha_v"}) {
        if (!properties.has(name)) continue;
        roughness.alpha = properties.number(name, 0.1);
        properties.replaced(fmt::format("anisotropic roughness by {} = {}", name, roughness.alpha),
                            place.error("anisotropic roughness; the isotropic alpha is accepted"));
    }
    const std::string distribution = properties.string("distribution", "beckmann");
    if (distribution == "ggx") {
        roughness.distribution = Microfacets::ggx;
    } else if (distribution != "beckmann") {
        properties.replaced(fmt::format("distribution '{}' by beckmann", distribution),
                            place.error(unknown_name("distribution", distribution, {"beckmann", "ggx"}).what()));
    }
    properties.boolean("sample_visible", true);
    return roughness;
}

}  // namespace plumb::description
