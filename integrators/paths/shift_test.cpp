#include "integrators/paths/shift.h"

#include <gtest/gtest.h>

#include "integrators/estimators/direct.h"
#include "integrators/estimators/path.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb {
namespace {

TEST(Shift, ReplaysEstimatorsThatKnowNoBetter) {
    const Scene scene(load_mitsuba(scene_file("cornell_box")));
    const Direct direct;
    const auto shift = direct.shift();
    IndependentSamples numbers({1, 0, 0});
    BasePath base;
    ShiftedPath shifted;
    PathRecord traced;
    shift->trace(scene, {10, 60, 1, 1}, numbers, base);
    shift->shift(scene, base, {40, 60, 1, 1}, numbers, shifted);
    direct.trace(scene, {40, 60, 1, 1}, numbers, traced);
    ASSERT_EQ(shifted.parts.size(), 1u);
    EXPECT_TRUE(shifted.parts[0].valid());
    EXPECT_EQ(light_of_part(shifted.splats, 0), traced.sum());
}

TEST(Shift, LeadsAPathToItsOwnPixelUnchanged) {
    const Scene scene(load_mitsuba(scene_file("cornell_box")));
    const PathTracer path;
    const auto shift = path.shift();
    const FilmRegion pixel{30, 60, 1, 1};
    BasePath base;
    ShiftedPath shifted;
    for (std::uint32_t i = 0; i < 100; ++i) {
        IndependentSamples numbers({1, 0, i});
        shift->trace(scene, pixel, numbers, base);
        shift->shift(scene, base, pixel, numbers, shifted);
        ASSERT_EQ(shifted.parts.size(), base.parts);
        for (std::size_t part = 0; part < base.parts; ++part) {
            const double truth = luminance(light_of_part(base.splats, part));
            ASSERT_TRUE(shifted.parts[part].valid()) << to_string(shifted.parts[part].failure);
            EXPECT_EQ(shifted.parts[part].jacobian, 1);
            EXPECT_NEAR(luminance(light_of_part(shifted.splats, part)), truth, 1e-2 * truth);
        }
    }
}

TEST(Shift, IsAFailureOffTheObjectWhereThePathWasConnected) {
    const Scene scene(load_mitsuba(scene_file("white_sphere")));  // under a sky
    const FilmSize film = scene.sensor().film();
    const PathTracer path;
    const auto shift = path.shift();
    BasePath base;
    ShiftedPath shifted;
    IndependentSamples numbers({1, 0, 0});
    shift->trace(scene, {film.width / 2, film.height / 2, 1, 1}, numbers, base);
    ASSERT_EQ(base.connection, 1u);
    shift->shift(scene, base, {0, 0, 1, 1}, numbers, shifted);
    ASSERT_EQ(shifted.parts.size(), 2u);
    EXPECT_TRUE(shifted.parts[0].valid());
    EXPECT_EQ(shifted.parts[1].failure, ShiftFailure::ended);
}

TEST(ShiftCounts, SayWhatFailedAndWhy) {
    ShiftedPath shifted;
    shifted.parts = {{}, {0.5}, {0, ShiftFailure::occluded}, {0, ShiftFailure::occluded}};
    ShiftCounts counts;
    counts.add(shifted);
    EXPECT_EQ(counts.total(), 4u);
    EXPECT_EQ(counts.describe(), "50.00 % of 4 parts shifted, 50.00 % occluded");
    EXPECT_EQ(ShiftCounts().describe(), "0.00 % of 0 parts shifted");
}

}  // namespace
}  // namespace plumb
