#include "integrators/drivers/render.h"

#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "core/parallel.h"
#include "integrators/drivers/explanation.h"
#include "integrators/drivers/frameless.h"
#include "integrators/drivers/pixels.h"
#include "integrators/integrators.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

const Scene& cornell_box() {
    static const Scene scene(load_mitsuba(scene_file("cornell_box"), {}));
    return scene;
}

std::vector<std::shared_ptr<const Driver>> some_drivers() {
    return {std::make_shared<IndependentPixels>(), std::make_shared<Frameless>(0.3)};
}

TEST(Render, PartsMergeToTheBitsOfTheWhole) {
    for (const char* id : {"path", "light"})
        for (const auto& driver : some_drivers()) {
            const auto estimator = make_integrator(id, {.max_edges = 4});
            const RenderSettings settings{.sampler = "stratified", .passes = 5, .seed = 9, .crop = {40, 40, 20, 17}};
            const auto film_of = [&](const RenderSettings& part, int threads) {
                std::optional<Film> film;
                with_threads(threads, [&] { film = render({cornell_box(), *estimator, part, driver}).film; });
                return *film;
            };
            const Film whole = film_of(settings, 2);
            Film merged(FilmSize{20, 17}, whole.layers());
            for (const std::uint32_t part : {3u, 1u, 2u})
                merged.merge(film_of(part_of(settings, part, 3), part == 1 ? 2 : 1));
            EXPECT_EQ(merged.replicates(), 5u);
            EXPECT_EQ(merged.image().values, whole.image().values) << id;
            EXPECT_THROW(part_of(settings, 6, 8), Error);
        }
}

TEST(Render, EndsWithThePassAfterWhichItIsToldTo) {
    const auto estimator = make_integrator("path", {.max_edges = 3});
    RenderSettings settings{.samples_per_pass = 1, .passes = 40, .seed = 4, .crop = {40, 40, 5, 5}};
    std::optional<Rendered> whole, ended;
    with_threads(2, [&] {
        std::uint64_t heard = 0, passes = 0;
        ended = render(cornell_box(), *estimator, settings, [&](const RenderProgress& at) {
            EXPECT_EQ(at.total, 40u);
            passes += at.done == heard;  // no piece is new: a pass entered the film
            heard = at.done;
            return passes < 7;
        });
    });
    settings.passes = 7;
    with_threads(1, [&] { whole = render(cornell_box(), *estimator, settings); });
    EXPECT_EQ(ended->film.replicates(), 7u);
    EXPECT_EQ(ended->film.image().values, whole->film.image().values);
    EXPECT_EQ(ended->rays, whole->rays);
}

TEST(Frameless, OfAllPixelsIsThePictureOfIndependentPixels) {
    const auto estimator = make_integrator("bdpt", {.max_edges = 3});
    const RenderSettings settings{.passes = 2, .seed = 4, .crop = {40, 40, 20, 17}};
    const auto image = [&](std::shared_ptr<const Driver> driver) {
        return render({cornell_box(), *estimator, settings, std::move(driver)}).film.image().values;
    };
    EXPECT_EQ(image(std::make_shared<Frameless>(1)), image(std::make_shared<IndependentPixels>()));
}

TEST(Frameless, DrawsItsShareOfEachTileWithTheWeightOfItsInverse) {
    const auto estimator = make_integrator("path", {});
    const RenderJob job{cornell_box(), *estimator, {.seed = 4, .crop = {10, 20, 20, 17}}};  // 20 × 17: four tiles
    const Frameless frameless(0.25);
    ASSERT_EQ(frameless.pieces(job), 4u);
    for (const auto& [tile, n, k] : {std::array{0u, 256u, 64u}, {1u, 64u, 16u}, {2u, 16u, 4u}, {3u, 4u, 1u}}) {
        const DrawnPixels drawn = frameless.drawn(job, 3, tile);
        EXPECT_EQ(drawn.pixels.size(), k);
        EXPECT_EQ(drawn.weight, static_cast<double>(n) / k);
        const std::set<std::uint32_t> different(drawn.pixels.begin(), drawn.pixels.end());
        EXPECT_EQ(different.size(), k);
        EXPECT_LT(*different.rbegin(), n);
        EXPECT_EQ(frameless.drawn(job, 3, tile).pixels, drawn.pixels);
    }
    EXPECT_NE(frameless.drawn(job, 3, 0).pixels, frameless.drawn(job, 4, 0).pixels);
}

TEST(Frameless, ExplainsWhatASampleCounts) {
    const auto estimator = make_integrator("path", {.max_edges = 3});
    const RenderJob job{cornell_box(),
                        *estimator,
                        {.samples_per_pass = 1, .passes = 8, .seed = 4, .crop = {40, 60, 2, 2}},
                        std::make_shared<Frameless>(0.5)};
    const Film film = render(job).film;
    double sum = 0;
    int counted = 0;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const Explanation told = explain(job, 41, 60, i);
        EXPECT_TRUE(told.weight == 0 || told.weight == 2);
        counted += told.weight > 0;
        sum += told.value[0];
    }
    EXPECT_GT(counted, 0);
    EXPECT_NEAR(sum / 8, film.mean(1, 0, 0), 1e-14);
}

}  // namespace
}  // namespace plumb
