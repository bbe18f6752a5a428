#include "estimators/reweighting/sample_weighting.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/random.h"
#include "estimators/estimator.h"

namespace plumb {
namespace {

using testing::HasSubstr;

// Every weighting is the estimator of the same name, on the same samples.
template <int D>
void expect_agreement_with_estimators() {
    for (const SampleWeighting<D>& weighting : sample_weightings<D>()) {
        std::vector<Point<D>> samples;
        const Function<D> f = [](const Point<D>& x) { return std::exp(x[0]) * (1 + x[D - 1]); };
        const Function<D> recorded = [&](const Point<D>& x) {
            samples.push_back(x);
            return f(x);
        };
        RandomStream random(11, 0);
        const Estimate estimate = find_estimator<D>(weighting.id).run(recorded, 50, random);
        double sum = 0;
        const std::vector<double> weights = weighting.weights(samples);
        for (std::size_t i = 0; i < samples.size(); ++i) sum += weights[i] * f(samples[i]);
        EXPECT_NEAR(sum, estimate.value, 1e-13) << weighting.id;
    }
}

TEST(SampleWeighting, IsTheEstimatorOfTheSameName) {
    expect_agreement_with_estimators<1>();
    expect_agreement_with_estimators<2>();
}

TEST(SampleWeighting, UnknownNamesAreExplained) {
    try {
        find_sample_weighting<2>("tours");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("did you mean 'torus'"));
    }
}

TEST(RepeatedPlaces, AreCountedOnTheDomain) {
    EXPECT_EQ(repeated_places<1>({{0.5}, {0.25}, {0.5}, {0.5}}, false), 2u);
    EXPECT_EQ(repeated_places<1>({{0}, {1}}, false), 0u);
    EXPECT_EQ(repeated_places<1>({{0}, {1}}, true), 1u);
    EXPECT_EQ(repeated_places<2>({{0, 0.5}, {1, 0.5}, {0.5, 0}, {0.5, 1}}, true), 2u);
    EXPECT_EQ(repeated_places<2>({{0, 0.5}, {0.5, 0}}, true), 0u);
}

}  // namespace
}  // namespace plumb
