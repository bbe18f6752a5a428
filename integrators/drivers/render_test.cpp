#include "integrators/drivers/render.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "integrators/integrators.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

TEST(Render, PartsMergeToTheBitsOfTheWhole) {
    const Scene scene(load_mitsuba(scene_file("cornell_box"), {}));
    for (const char* id : {"path", "light"}) {
        const auto estimator = make_integrator(id, {.max_edges = 4});
        const RenderSettings settings{.sampler = "stratified", .passes = 5, .seed = 9, .crop = {40, 40, 20, 17}};
        std::optional<Film> whole;
        with_threads(2, [&] { whole = render(scene, *estimator, settings).film; });
        Film merged(FilmSize{20, 17}, render_layers());
        for (const std::uint32_t part : {3u, 1u, 2u})
            with_threads(part == 1 ? 2 : 1,
                         [&] { merged.merge(render(scene, *estimator, part_of(settings, part, 3)).film); });
        EXPECT_EQ(merged.replicates(), 5u);
        EXPECT_EQ(merged.image().values, whole->image().values) << id;
        EXPECT_THROW(part_of(settings, 6, 8), Error);
    }
}

}  // namespace
}  // namespace plumb
