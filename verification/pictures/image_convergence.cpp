#include "verification/pictures/image_convergence.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/moments.h"

namespace plumb {
namespace {

constexpr int block = 8;

void require_like(const Picture& picture, const Picture& reference, const std::string& file) {
    if (picture.width != reference.width || picture.height != reference.height)
        throw Error(fmt::format("{}: is {}x{} pixels, the reference {}x{}", file, picture.width, picture.height,
                                reference.width, reference.height));
    if (picture.channels != reference.channels)
        throw Error(fmt::format("{}: does not have the reference's channels", file));
}

bool is_finite(const RendersAt& at, const Picture& reference, std::size_t k) {
    return std::isfinite(reference.mean[k]) &&
           std::ranges::all_of(at.renders, [&](const Picture& render) { return std::isfinite(render.mean[k]); });
}

/// A mean over pixels of something that each render has, with its variance.
class MeanOverPixels {
public:
    explicit MeanOverPixels(std::size_t renders) : block_(renders), total_(renders) {}

    /// Adds a value of the next pixel, by the render of this number.
    void add(std::size_t render, double value) { block_[render] += value; }
    void end_block(double pixels) {
        if (pixels == 0) return;
        const auto n = static_cast<double>(block_.size());
        Moments spread;
        for (std::size_t i = 0; i < block_.size(); ++i) {
            spread.add(block_[i]);
            total_[i] += block_[i];
        }
        if (block_.size() > 1) square_ += spread.variance() / n;
        blocks_.add(block_[0] / pixels);
        pixels_ += pixels;
        std::ranges::fill(block_, 0);
    }
    [[nodiscard]] double mean() const {
        double sum = 0;
        for (const double total : total_) sum += total;
        return sum / static_cast<double>(total_.size()) / pixels_;
    }
    [[nodiscard]] double variance() const {
        return total_.size() > 1 ? square_ / pixels_ / pixels_ : blocks_.standard_error() * blocks_.standard_error();
    }
    [[nodiscard]] double pixels() const { return pixels_; }

private:
    std::vector<double> block_, total_;  // sums, render by render
    double square_ = 0, pixels_ = 0;
    Moments blocks_;
};

}  // namespace

ConvergencePoint convergence_point(const RendersAt& at, const Picture& reference) {
    for (std::size_t i = 0; i < at.renders.size(); ++i) require_like(at.renders[i], reference, at.files[i]);
    const std::size_t channels = reference.channels.size();
    const auto share = 1 / static_cast<double>(channels);
    MeanOverPixels squares(at.renders.size()), differences(at.renders.size());
    double of_reference = 0, of_reference_squared = 0;  // summed over pixels: v, and what it does to the MSE's variance
    for (int top = 0; top < reference.height; top += block)
        for (int left = 0; left < reference.width; left += block) {
            double pixels = 0;
            for (int y = top; y < std::min(top + block, reference.height); ++y)
                for (int x = left; x < std::min(left + block, reference.width); ++x) {
                    const std::size_t first = reference.at(x, y, 0);
                    if (!is_finite(at, reference, first)) continue;
                    ++pixels;
                    double v = 0;
                    for (std::size_t k = first; k < first + channels; ++k) {
                        v += share * reference.variance[k];
                        for (std::size_t i = 0; i < at.renders.size(); ++i) {
                            const double d = at.renders[i].mean[k] - reference.mean[k];
                            squares.add(i, share * (d * d - reference.variance[k]));
                            differences.add(i, share * d);
                        }
                    }
                    of_reference += v;
                    of_reference_squared += 2 * v * v;  // of (b − truth)² − v for normal b, its channels as one
                }
            squares.end_block(pixels);
            differences.end_block(pixels);
        }
    const double n = squares.pixels();
    if (n == 0) throw Error(fmt::format("{}: has no pixel that is finite in all images", at.files[0]));
    ConvergencePoint point{.n = at.samples,
                           .evaluations = static_cast<double>(at.samples) * n,
                           .seconds = at.seconds,
                           .bias = differences.mean(),
                           .bias_standard_error = std::sqrt(differences.variance() + of_reference / n / n)};
    set_mse(point, squares.mean(), std::sqrt(squares.variance() + of_reference_squared / n / n));
    return point;
}

double power_of(const Picture& picture) {
    Moments power;
    for (std::size_t k = 0; k < picture.mean.size(); ++k)
        if (std::isfinite(picture.mean[k])) power.add(picture.mean[k] * picture.mean[k] - picture.variance[k]);
    return power.mean();
}

}  // namespace plumb
