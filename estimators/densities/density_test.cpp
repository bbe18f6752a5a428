#include "estimators/densities/density.h"

#include "core/random.h"
#include "estimators/densities/density_2d.h"
#include "estimators/densities/piecewise_constant.h"

namespace plumb {
namespace {

template <class Density>
class OneDimensional : public ::testing::Test {};

struct Uniform : UniformDensity {};
struct Linear : LinearDensity {
    Linear() : LinearDensity(1, 3) {}
};
struct Rising : LinearDensity {
    Rising() : LinearDensity(0, 5) {}
};
struct Falling : LinearDensity {
    Falling() : LinearDensity(1e300, 0) {}
};
struct Decaying : TruncatedExponential {
    Decaying() : TruncatedExponential(6) {}
};
struct Growing : TruncatedExponential {
    Growing() : TruncatedExponential(-3) {}
};
struct NearlyFlat : TruncatedExponential {
    NearlyFlat() : TruncatedExponential(1e-12) {}
};
struct Steps : PiecewiseConstant {
    Steps() : PiecewiseConstant(std::vector<double>{0, 3, 0, 1, 4, 0}) {}
};
using All = ::testing::Types<Uniform, Linear, Rising, Falling, Decaying, Growing, NearlyFlat, Steps>;
TYPED_TEST_SUITE(OneDimensional, All);

TYPED_TEST(OneDimensional, InvertUndoesSample) {
    const TypeParam density;
    RandomStream random(1);
    for (int i = 0; i < 2000; ++i) {
        const double u = random.uniform();
        ASSERT_NEAR(density.invert(density.sample(u)), u, 4e-16);
    }
}

TYPED_TEST(OneDimensional, EndsOfTheUnitIntervalStayInside) {
    const TypeParam density;
    for (const double u : {0.0, 0x1p-53, 1 - 0x1p-53}) {
        const double x = density.sample(u);
        EXPECT_GE(x, 0);
        EXPECT_LE(x, 1);
        EXPECT_NEAR(density.invert(x), u, 4e-16);
    }
    EXPECT_EQ(density.invert(0), 0);
    EXPECT_NEAR(density.invert(1), 1, 4e-16);
    EXPECT_EQ(density.pdf(-1e-9), 0);
    EXPECT_EQ(density.pdf(1 + 1e-9), 0);
}

TYPED_TEST(OneDimensional, SamplesWherePdfIsPositive) {
    const TypeParam density;
    RandomStream random(2);
    for (int i = 0; i < 2000; ++i) ASSERT_GT(density.pdf(density.sample(random.uniform())), 0);
}

TEST(LinearDensity, HasItsValues) {
    const LinearDensity density(1, 3);  // 1/2 + x
    EXPECT_DOUBLE_EQ(density.pdf(0), 0.5);
    EXPECT_DOUBLE_EQ(density.pdf(1), 1.5);
    EXPECT_DOUBLE_EQ(density.invert(0.5), 0.375);
    EXPECT_DOUBLE_EQ(density.sample(0.375), 0.5);
    EXPECT_DOUBLE_EQ(LinearDensity(2, 2).sample(0.3), 0.3);
}

TEST(TruncatedExponential, HasItsValues) {
    const TruncatedExponential density(std::log(4.0));  // 1 − 4^−x over 3/4
    EXPECT_DOUBLE_EQ(density.pdf(0), std::log(4.0) / 0.75);
    EXPECT_NEAR(density.invert(0.5), 2.0 / 3, 1e-15);
    EXPECT_EQ(TruncatedExponential(0).sample(0.3), 0.3);
    EXPECT_EQ(TruncatedExponential(0).pdf(0.3), 1);
}

TEST(PiecewiseConstant, HasItsValues) {
    const PiecewiseConstant density(std::vector<double>{1, 0, 3, 4});
    EXPECT_DOUBLE_EQ(density.pdf(0.1), 0.5);
    EXPECT_EQ(density.pdf(0.3), 0);
    EXPECT_DOUBLE_EQ(density.pdf(0.6), 1.5);
    EXPECT_DOUBLE_EQ(density.pdf(1), 2);
    EXPECT_DOUBLE_EQ(density.sample(0.125), 0.5);  // the first point after the empty cell
}

TEST(BilinearDensity, InvertUndoesSampleAndHasItsValues) {
    const BilinearDensity density(1, 2, 0, 5);
    RandomStream random(3);
    for (int i = 0; i < 2000; ++i) {
        const Point<2> u{random.uniform(), random.uniform()};
        const Point<2> back = density.invert(density.sample(u));
        ASSERT_NEAR(back[0], u[0], 1e-15);
        ASSERT_NEAR(back[1], u[1], 1e-15);
    }
    EXPECT_DOUBLE_EQ(density.pdf({0, 0}), 1 / 2.0);  // the mean of the corners is 2
    EXPECT_DOUBLE_EQ(density.pdf({1, 1}), 5 / 2.0);
    EXPECT_DOUBLE_EQ(density.pdf({0.5, 0.5}), 1);
    EXPECT_EQ(density.pdf({0.5, 1.5}), 0);
}

TEST(ProductDensity, MultipliesItsAxes) {
    const ProductDensity<LinearDensity, UniformDensity> density{LinearDensity(1, 3), {}};
    EXPECT_DOUBLE_EQ(density.pdf({0.5, 0.2}), 1);
    EXPECT_DOUBLE_EQ(density.sample({0.375, 0.2})[0], 0.5);
    EXPECT_EQ(density.invert({0.5, 0.2})[1], 0.2);
}

TEST(Densities, RefuseWhatIsNone) {
    EXPECT_THROW(LinearDensity(0, 0), Error);
    EXPECT_THROW(LinearDensity(-1, 2), Error);
    EXPECT_THROW(LinearDensity(1, std::nan("")), Error);
    EXPECT_THROW(TruncatedExponential{1000}, Error);
    EXPECT_THROW(BilinearDensity(3, 1, -1, 1), Error);
    EXPECT_THROW(PiecewiseConstant(std::vector<double>{0, 0}), Error);
    EXPECT_THROW(PiecewiseConstant(std::vector<double>{}), Error);
    EXPECT_THROW(PiecewiseConstant(std::vector<double>{1, INFINITY}), Error);
}

}  // namespace
}  // namespace plumb
