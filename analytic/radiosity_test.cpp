#include "analytic/radiosity_cases.h"

#include <gtest/gtest.h>

#include <numbers>

#include "analytic/irradiance.h"
#include "core/error.h"

namespace plumb {
namespace {

std::vector<RadiosityPlate> two_plates() {
    return facing_plates(1, 0.8, 0.5);
}

TEST(Radiosity, InAClosedBoxThatShinesEverywhereIsAGeometricSeries) {
    std::array<double, 6> halves{}, ones{};
    halves.fill(0.5);
    ones.fill(1);
    for (const int reflections : {1, 3, -1}) {
        const Radiosity radiosity(cube(halves, ones), 3, reflections);
        const double truth = reflections < 0 ? 2 : 2 - std::pow(0.5, reflections);
        EXPECT_NEAR(radiosity.radiance(0, 0.5, 0.5), truth, 1e-7) << reflections;
        EXPECT_NEAR(radiosity.radiance(3, 0.01, 0.3), truth, 1e-6) << reflections;
    }
}

TEST(Radiosity, OfOneReflectionIsIrradiance) {
    const auto plates = two_plates();
    const Radiosity radiosity(plates, 4, 1);
    const RadiosityPlate& light = plates[1];
    const double irradiance = polygon_irradiance(
        {0.2, 0.3, 0}, {0, 0, 1}, {light.point(0, 0), light.point(1, 0), light.point(1, 1), light.point(0, 1)});
    EXPECT_NEAR(radiosity.radiance(0, 0.2, 0.3), 0.8 * irradiance / std::numbers::pi, 1e-8);
}

// In a closed box all that is emitted is absorbed: since k is symmetric and ∫ k dA = 1, ∫ (1/ρ − 1) (L − L_e) dA = ∫
// L_e dA.
TEST(Radiosity, InAClosedBoxIsAbsorbedAsItIsEmitted) {
    for (const int n : {4, 8}) {
        const Radiosity radiosity(cube(uneven_albedos, lit_from_above), n);
        double absorbed = 0;
        for (std::size_t i = 0; i < 6; ++i)
            absorbed += (1 / uneven_albedos[i] - 1) * (radiosity.integral(i) - lit_from_above[i]);
        EXPECT_NEAR(absorbed, 1, n == 4 ? 5e-4 : 6e-5) << n;
    }
}

TEST(Radiosity, ConvergesInTheDegree) {
    const auto between_plates = [](int n) { return Radiosity(two_plates(), n).radiance(0, 0.2, 0.3); };
    EXPECT_NEAR(between_plates(6), between_plates(10), 1e-9);
    const auto in_cube = [](int n) { return Radiosity(cube(uneven_albedos, lit_from_above), n); };
    const Radiosity coarse = in_cube(6), fine = in_cube(8);
    EXPECT_NEAR(coarse.radiance(0, 0.5, 0.5), fine.radiance(0, 0.5, 0.5), 2e-6);
    EXPECT_NEAR(coarse.radiance(2, 0.5, 0.5), fine.radiance(2, 0.5, 0.5), 5e-6);
}

TEST(Radiosity, OfTheCasesIsKnownWithinTheirErrors) {
    for (const RadiosityCase& one : radiosity_cases()) {
        const Radiosity coarse(one.plates, 8), fine(one.plates, 12);
        for (const auto& [plate, s, t] : one.points)
            EXPECT_NEAR(coarse.radiance(plate, s, t) / fine.radiance(plate, s, t), 1, one.error) << one.id;
    }
}

TEST(Radiosity, RefusesWhatNeverEnds) {
    auto plates = two_plates();
    plates[1].albedo = 1;
    EXPECT_THROW(Radiosity(plates, 4), Error);
    plates[1].albedo = std::nan("");
    EXPECT_THROW(Radiosity(plates, 4), Error);
    std::array<double, 6> nearly_white{};
    nearly_white.fill(1 - 1e-9);
    EXPECT_THROW(Radiosity(cube(nearly_white, lit_from_above), 2), Error);
}

TEST(Radiosity, RefusesWhatItCannotMean) {
    auto plates = two_plates();
    for (const int reflections : {0, -2}) EXPECT_THROW(Radiosity(plates, 2, reflections), Error) << reflections;
    plates[1].emission = HUGE_VAL;
    EXPECT_THROW(Radiosity(plates, 2), Error);
}

}  // namespace
}  // namespace plumb
