#include "scenes/bsdfs/microfacet.h"

#include <gtest/gtest.h>

#include <numbers>

namespace plumb {
namespace {

using std::numbers::pi;

TEST(Microfacets, AreWhollyVisibleFromTheNormal) {
    for (const MicrofacetShape shape : {MicrofacetShape::ggx, MicrofacetShape::beckmann}) {
        const Microfacets facets{shape, 0.3};
        EXPECT_DOUBLE_EQ(facets.d({0, 0, 1}), 1 / (pi * 0.09));
        EXPECT_EQ(facets.g1({0, 0, 1}, {0, 0, 1}), 1);
        EXPECT_EQ(facets.g1({0.6, 0, 0.8}, {-0.96, 0, 0.28}), 0);
    }
}

TEST(Microfacets, ProjectTheirVisibleAreaOntoTheirSurface) {  // ∫ G1 (wo·m)+ D dm = wo.z
    for (const MicrofacetShape shape : {MicrofacetShape::ggx, MicrofacetShape::beckmann}) {
        const Microfacets facets{shape, 0.5};
        const Vec3 wo{0.8, 0, 0.6};
        constexpr int n = 1000;
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double z = (i + 0.5) / n, phi = 2 * pi * (j + 0.5) / n, r = std::sqrt(1 - z * z);
                sum += facets.visible_pdf(wo, {r * std::cos(phi), r * std::sin(phi), z}) * 2 * pi / (n * n);
            }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
}

TEST(Microfacets, SampleTheTailsWithoutFail) {
    for (const MicrofacetShape shape : {MicrofacetShape::ggx, MicrofacetShape::beckmann})
        for (const double alpha : {1e-4, 0.1, 1.0})
            for (const double z : {1e-9, 1e-3, 0.5, 1.0})
                for (const double u : {0.0, 0x1p-53, 0.5, 1 - 0x1p-53})
                    for (const double v : {0.0, 0x1p-53, 0.5, 1 - 0x1p-53}) {
                        const Vec3 wo{std::sqrt(1 - z * z), 0, z};
                        const Vec3 m = Microfacets{shape, alpha}.sample_visible(wo, {u, v});
                        EXPECT_NEAR(length(m), 1, 1e-14);
                        EXPECT_GE(m.z, 0);
                        const bool half_vector_vanishes = u == 0.5 && v > 0.5;
                        EXPECT_TRUE(half_vector_vanishes || dot(wo, m) >= -1e-8);
                    }
}

}  // namespace
}  // namespace plumb
