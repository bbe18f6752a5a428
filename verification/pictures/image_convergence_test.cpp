#include "verification/pictures/image_convergence.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/moments.h"
#include "verification/pictures/synthetic_render.h"

namespace plumb {
namespace {

/// Exponential noise about a grey ramp: a sample has the variance of its squared radiance.
SyntheticRender ramp(int samples) {
    return {.samples = samples,
            .truth =
                [](int x, int) {
                    return SyntheticRender::Colour{1 + x / 31.0, 1 + x / 31.0, 1 + x / 31.0};
                },
            .law = exponential_noise};
}

/// ⟨truth²⟩, exactly: Σ (1 + x/31)² over x = 0 … 31, divided by 32.
constexpr double power = 1 + 1 + (63.0 / 6) / 31;

Picture picture(std::uint64_t seed, int samples, bool exact) {
    const std::vector<Image> images{ramp(samples)(seed)};
    return picture_of(images, std::vector<std::string>{"a"}, exact);
}

RendersAt renders(std::uint64_t first, int count, int samples) {
    RendersAt at{.samples = static_cast<std::uint64_t>(16 * samples)};
    for (int i = 0; i < count; ++i) {
        at.renders.push_back(picture(first + static_cast<std::uint64_t>(i), samples, true));
        at.files.push_back("render");
    }
    return at;
}

Picture truth() {
    Picture truth = picture(1, 1, true);
    for (std::size_t k = 0; k < truth.mean.size(); ++k) truth.mean[k] = 1 + static_cast<double>(k / 3 % 32) / 31;
    return truth;
}

TEST(ImageConvergence, OfTheTruthIsTheVariance) {
    EXPECT_NEAR(power_of(truth()), power, 1e-9);
    for (const int samples : {1, 4}) {
        const ConvergencePoint point = convergence_point(renders(10, 4, samples), truth());
        const double expected = power / (16 * samples);
        EXPECT_NEAR(point.mse, expected, 5 * point.log_mse_error * point.mse);
        EXPECT_NEAR(point.bias, 0, 5 * point.bias_standard_error);
        // 4096 pixels of kurtosis 3 + 6/n; (1 + x/31)^4 has the mean 6.33, 1.146 times the square of that of squares.
        EXPECT_NEAR(point.log_mse_error, std::sqrt((2 + 6.0 / (16 * samples)) * 1.146 / 4096), 0.005);
    }
}

/// A reference of as many samples doubles the squared difference, and a bias adds its square.
TEST(ImageConvergence, DoesNotCountTheReferencesOwnVariance) {
    const ConvergencePoint point = convergence_point(renders(10, 4, 1), picture(3, 1, false));
    EXPECT_NEAR(point.mse, power / 16, 5 * point.log_mse_error * point.mse);
    EXPECT_LT(point.log_mse_error, 0.1);
    RendersAt biased = renders(10, 2, 4);
    for (Picture& render : biased.renders)
        for (double& value : render.mean) value += 1;
    const ConvergencePoint off = convergence_point(biased, truth());
    EXPECT_NEAR(off.bias, 1, 5 * off.bias_standard_error);
    EXPECT_NEAR(off.mse, 1 + power / 64, 5 * off.log_mse_error * off.mse);
}

/// The error of the MSE is the spread of the MSE, whether neighbours are alike or not.
TEST(ImageConvergence, KnowsItsOwnError) {
    for (const bool alike : {false, true}) {
        Moments values, squared_errors, alone;
        for (std::uint64_t run = 0; run < 100; ++run) {
            RendersAt at = renders(100 + 4 * run, 3, 1);
            for (Picture& render : at.renders)
                for (std::size_t k = 0; alike && k < render.mean.size(); ++k)  // pairs of pixels are one
                    if (k / 3 % 2 == 1) render.mean[k] = render.mean[k - 3];
            const ConvergencePoint point = convergence_point(at, truth());
            values.add(point.mse);
            squared_errors.add(std::pow(point.log_mse_error * point.mse, 2));
            at.renders.resize(1);
            alone.add(std::pow(convergence_point(at, truth()).log_mse_error, 2));
        }
        // 100 runs tell a variance to 14 %.
        EXPECT_NEAR(squared_errors.mean() / values.variance(), 1, 0.6);
        EXPECT_GT(alone.mean() * std::pow(values.mean(), 2), 2 * values.variance());  // three times, and more
    }
}

TEST(ImageConvergence, NamesTheImageThatIsOfAnotherSize) {
    RendersAt at = renders(1, 1, 1);
    at.renders[0].width = 16;
    EXPECT_THROW(convergence_point(at, truth()), Error);
}

}  // namespace
}  // namespace plumb
