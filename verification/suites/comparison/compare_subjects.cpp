#include "verification/suites/comparison/compare_subjects.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/srgb.h"
#include "verification/evidence/distributions.h"

namespace plumb::suites {

namespace {

constexpr std::size_t channels = 6;

Picture picture(const Renders& renders) {
    return picture_of(renders.images, std::vector<std::string>(renders.images.size(), "render"));
}

bool touches(const PixelBox& box, const PixelBox& place) {
    return box.x < place.x + place.width && place.x < box.x + box.width && box.y < place.y + place.height &&
           place.y < box.y + box.height;
}

}  // namespace

Image changed(Image image, const Change& change) {
    for (int i = 0; i < image.width * image.height; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            float& value = image.values[static_cast<std::size_t>(i) * channels + c];
            float& variance = image.values[static_cast<std::size_t>(i) * channels + 3 + c];
            const int x = i % image.width, y = i / image.width;
            const double at = value, slope = (change(1.001 * at, x, y) - change(at, x, y)) / (0.001 * at);
            value = static_cast<float>(change(at, x, y));
            if (at != 0) variance = static_cast<float>(variance * slope * slope);
        }
    return image;
}

Image with_variance(Image image, double scale) {
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (i % channels >= 3) image.values[i] = static_cast<float>(image.values[i] * scale);
    return image;
}

Image in_bytes(Image image) {
    for (std::size_t i = 0; i < image.values.size(); ++i)
        if (i % channels < 3)
            image.values[i] = static_cast<float>(
                linear_from_srgb(std::round(255 * srgb_from_linear(std::clamp<double>(image.values[i], 0, 1))) / 255));
    return image;
}

Image blurred(const Image& image) {
    Image out = image;
    const auto near = [](int i, int step, int size) { return std::clamp(i + step - 1, 0, size - 1); };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0;
                for (int k = 0; k < 9; ++k)
                    sum += image.at(near(x, k % 3, image.width), near(y, k / 3, image.height), c);
                out.values[static_cast<std::size_t>(y * image.width + x) * channels + c] = sum / 9;
            }
    return out;
}

ImageComparison compared(const TwoSides& sides, double alpha, int tile) {
    return compare(picture(sides.first), picture(sides.second), {.alpha = alpha, .tile = tile});
}

bool is_refuted(const TwoSides& sides, double alpha) {
    return compared(sides, alpha).verdict.outcome == Outcome::refuted;
}

Verdict comparison_shows(const Compared& subject, const Run& run, int tile) {
    const PixelBox& place = subject.place;
    RandomStream random = run.random(0);
    const ImageComparison found = compared(subject.pair(random.bits() >> 8), run.alpha(), tile);
    Verdict verdict = found.verdict;
    const bool shown = !found.differing.empty() && touches(found.tiles[found.differing.front()].box, place);
    if (verdict.outcome == Outcome::refuted && place.width > 0 && !shown) {
        verdict.outcome = Outcome::undecided;
        verdict.reason = "refuted, but the place is not shown: " + verdict.reason;
    }
    return verdict;
}

Verdict pairs_are_not_refuted(const std::function<TwoSides(std::uint64_t number, RandomStream& random)>& pair,
                              const Run& run) {
    constexpr double alpha = 1e-5, most = 0.05;
    const auto pairs = run.pick<std::uint64_t>(200, 2000);
    std::uint64_t refuted = 0;
    const auto at_least = [&] { return clopper_pearson(refuted, pairs, run.alpha()).low; };
    for (std::uint64_t i = 0; i < pairs; ++i) {
        RandomStream random = run.random(i);
        if (!is_refuted(pair(i, random), alpha)) continue;
        ++refuted;
        if (at_least() > alpha) break;  // whatever the others are
    }
    const double low = at_least(), high = clopper_pearson(refuted, pairs, run.beta()).high;
    Verdict verdict;
    verdict.samples = pairs;
    verdict.deviation = {low, high};
    verdict.resolution = most;
    verdict.outcome = low > alpha ? Outcome::refuted : high < most ? Outcome::holds : Outcome::undecided;
    verdict.reason = fmt::format("{} of {} honest pairs refuted at {} each", refuted, pairs, alpha);
    return verdict;
}

}  // namespace plumb::suites
