#include "integrators/drivers/render_until.h"

#include <gmock/gmock.h>

#include <cmath>

#include "integrators/integrators.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

using testing::ElementsAre;

class RenderUntil : public testing::Test {
protected:
    RenderedUntil until(const ErrorTarget& target, std::uint32_t most) {
        looks.clear();
        return render_until(job_of(scene, *estimator, settings), target, most,
                            {[&](std::uint64_t passes, const FilmError&) { looks.push_back(passes); }, {}});
    }

    Scene scene{load_mitsuba(scene_file("quad_light"))};
    std::unique_ptr<PathEstimator> estimator = make_integrator("direct-emitters", {});
    RenderSettings settings{.samples_per_pass = 1, .seed = 5, .crop = {40, 40, 16, 16}};
    std::vector<std::uint64_t> looks;
};

TEST_F(RenderUntil, DoublesItsPassesAndIsThenTheSamePicture) {
    const RenderedUntil done = until({1e-9, true}, 40);
    EXPECT_FALSE(done.met);
    EXPECT_THAT(looks, ElementsAre(16, 32, 40));
    settings.passes = 40;
    const Rendered at_once = render(scene, *estimator, settings);
    EXPECT_EQ(done.rendered.film.image().values, at_once.film.image().values);
    EXPECT_EQ(done.rendered.rays, at_once.rays);
    EXPECT_EQ(done.error.relative, error_of(at_once.film).relative);
}

TEST_F(RenderUntil, EndsWhereTheErrorIsReached) {
    const double first = until({1, true}, 1024).error.relative;
    const RenderedUntil done = until({first / 3, true}, 1024);  // errors fall as 1/√passes: 16 times 9
    EXPECT_TRUE(done.met);
    EXPECT_THAT(looks, ElementsAre(16, 32, 64, 128, 256));
    EXPECT_LE(done.error.relative, first / 3);
    EXPECT_NEAR(done.error.relative, first / 4, 0.1 * first / 4);
    EXPECT_EQ(until({done.error.rmse, false}, 1024).rendered.film.replicates(), 256u);
}

// Every path brings 1, and one in so many a spike beside it.
struct Spiky final : PathEstimator {
    double chance;
    explicit Spiky(double one_in) : chance(1 / one_in) {}
    void trace(const Scene&, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const override {
        record.clear();
        const bool spike = samples.at({0, Use::lobe}).u[0] < chance;
        record.add({{region.x + 0.5, region.y + 0.5}, Spectrum::grey(spike ? 1 + 0.2 / chance : 1), 2}, 1);
    }
};

TEST_F(RenderUntil, GoesOnWhileFewPathsCarryMuch) {
    estimator = std::make_unique<Spiky>(512);  // 256 pixels: a spike in two passes
    const RenderedUntil undecided = until({10, true}, 16);
    EXPECT_TRUE(meets(undecided.error, {10, true}));
    EXPECT_FALSE(undecided.met);
    EXPECT_TRUE(undecided.grounds.few_carry_much());
    const RenderedUntil met = until({10, true}, 4096);
    EXPECT_TRUE(met.met);
    EXPECT_GE(met.rendered.film.replicates(), 32u);
}

TEST_F(RenderUntil, DoesNotTrustAPictureThatMayLackALight) {
    description::Scene two = scene.description();
    two.emitters.push_back({description::PointLight{{0, 0, 5}, Spectrum::grey(1e-9)}, {}});
    scene = Scene(two, LightChooser::by_power);
    const RenderedUntil lacking = until({1, true}, 32);
    EXPECT_TRUE(meets(lacking.error, {1, true}));
    EXPECT_TRUE(lacking.grounds.light_may_be_missing());
    EXPECT_FALSE(lacking.met);
    scene = Scene(two);
    EXPECT_TRUE(until({1, true}, 32).met);
}

}  // namespace
}  // namespace plumb
