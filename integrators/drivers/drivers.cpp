#include "integrators/drivers/drivers.h"

#include "core/named.h"
#include "integrators/drivers/frameless.h"
#include "integrators/drivers/pixels.h"

namespace plumb {

const std::vector<NamedDriver>& drivers() {
    static const std::vector<NamedDriver> all{
        {"pixels",
         "every pixel takes its samples in every pass",
         "ours, integrators/drivers/pixels.h",
         {},
         [](const RenderJob&, const Parameters&) -> std::unique_ptr<Driver> {
             return std::make_unique<IndependentPixels>();
         }},
        {"frameless",
         "each pass draws some of the pixels of each tile, in random order",
         "[Bishop et al. 1994]",
         {{"pixel-share", "of a tile's pixels that a pass draws", Parameter::Real{0.25, 0.001, 1}}},
         [](const RenderJob&, const Parameters& parameters) -> std::unique_ptr<Driver> {
             return std::make_unique<Frameless>(parameters.real("pixel-share"));
         }},
    };
    return all;
}

const NamedDriver& find_driver(const std::string& id) {
    return find_named(drivers(), id, "driver");
}

}  // namespace plumb
