#include "core/vec3.h"

#include <gtest/gtest.h>

#include "core/primary_samples.h"
#include "core/spectrum.h"

namespace plumb {
namespace {

TEST(Frame, IsRightHandedAndOrthonormalForEveryNormal) {
    for (const Vec3 normal :
         {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, normalize({1, -2, 3}), normalize({1e-9, 0, -1})}) {
        const Frame frame(normal);
        EXPECT_NEAR(length(frame.x), 1, 1e-15);
        EXPECT_NEAR(dot(frame.x, frame.y), 0, 1e-15);
        EXPECT_NEAR(length(cross(frame.x, frame.y) - frame.z), 0, 1e-15);
        const Vec3 v{0.3, -0.5, 0.7};
        EXPECT_NEAR(length(frame.to_world(frame.to_local(v)) - v), 0, 1e-15);
    }
}

TEST(Spectrum, WorksLaneByLane) {
    const Spectrum a = Spectrum::rgb(1, 2, 3), b = Spectrum::grey(2);
    EXPECT_EQ(a * b, Spectrum::rgb(2, 4, 6));
    EXPECT_EQ((a + b) / 2, Spectrum::rgb(1.5, 2, 2.5));
    EXPECT_NEAR(luminance(Spectrum::grey(0.5)), 0.5, 1e-15);
    EXPECT_TRUE(is_black(a - a));
}

TEST(IndependentSamples, AreAFunctionOfKeyAndSlot) {
    IndependentSamples a({7, 3, 1}), b({7, 3, 1});
    const Drawn skipped = a.at({2, Use::lobe});
    static_cast<void>(b.at({1, Use::light}));
    EXPECT_EQ(b.at({2, Use::lobe}).u, skipped.u);
    EXPECT_NE(a.at({2, Use::direction}).u, skipped.u);
    EXPECT_NE(a.at({3, Use::lobe}).u, skipped.u);
}

}  // namespace
}  // namespace plumb
