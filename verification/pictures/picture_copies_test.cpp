#include "verification/pictures/picture_copies.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "core/random.h"

namespace plumb {
namespace {

using testing::HasSubstr;

Picture noise(std::uint64_t seed) {
    RandomStream random(seed, stream_id("copies"), 0);
    Picture picture{.width = 16, .height = 16, .channels = {"Y"}};
    for (int i = 0; i < 256; ++i) picture.mean.push_back(2 * random.uniform());
    picture.variance.assign(256, 0.01);
    return picture;
}

Picture changed(Picture picture, const std::function<double(double)>& change) {
    for (double& value : picture.mean) value = change(value);
    return picture;
}

TEST(CopiesOf, NamesWhatWasDone) {
    const Picture a = noise(1);
    EXPECT_EQ(copies_of(a, a), "b is a copy of a, the same samples and no second estimate");
    const auto of = [&](const std::function<double(double)>& change) { return copies_of(a, changed(a, change)); };
    EXPECT_THAT(of([](double v) { return std::min(v, 1.0); }), HasSubstr("b is a copy of a, cut off at 1,"));
    EXPECT_THAT(of([](double v) { return std::round(v * 20) / 20; }), HasSubstr("levels, as few bits have"));
    EXPECT_THAT(of([](double v) { return 1.25 * v; }), HasSubstr("multiplied by 1.25"));
    EXPECT_THAT(of([](double v) { return std::sqrt(v); }), HasSubstr("changed by a curve"));
}

TEST(CopiesOf, KnowsHalvesBytesAndChannels) {
    const auto three = [](std::uint64_t seed, double scale) {
        RandomStream random(seed, stream_id("copies"), 0);
        Picture picture{.width = 32, .height = 32, .channels = {"R", "G", "B"}};
        for (int i = 0; i < 3 * 32 * 32; ++i) picture.mean.push_back(scale * random.uniform());
        picture.variance.assign(picture.mean.size(), 0.01);
        return picture;
    };
    const Picture a = three(1, 2), dim = three(1, 1e-6);
    const auto half = [](double v) {
        int exponent = 0;
        (void)std::frexp(v, &exponent);
        exponent = std::max(exponent, -13);  // halves below 2^-14 are multiples of 2^-24
        return std::ldexp(std::round(std::ldexp(v, 11 - exponent)), exponent - 11);
    };
    EXPECT_THAT(copies_of(a, changed(a, half)), HasSubstr("b is a copy of a, rounded to half floats,"));
    EXPECT_THAT(copies_of(dim, changed(dim, half)), HasSubstr("b is a copy of a, rounded to half floats,"));
    const auto bytes = [](double v) { return std::round(255 * std::pow(std::min(v, 1.0), 1 / 2.2)) / 255; };
    EXPECT_THAT(copies_of(a, changed(a, bytes)), HasSubstr("b is a copy of a, cut off at 1 and rounded to "));
    EXPECT_THAT(copies_of(changed(a, bytes), a), HasSubstr("a is a copy of b, cut off at 1 and rounded to "));
    Picture balanced = a;
    for (std::size_t k = 0; k < a.mean.size(); ++k) balanced.mean[k] *= 1 + 0.25 * static_cast<double>(k % 3);
    EXPECT_THAT(copies_of(a, balanced), HasSubstr("b is a copy of a, multiplied by 1, 1.25, 1.5,"));
    EXPECT_EQ(copies_of(three(1, 1), three(2, 1)), "");
}

TEST(CopiesOf, SaysWhichIsTheOriginal) {
    const Picture a = noise(1), cut = changed(a, [](double v) { return std::min(v, 1.0); });
    EXPECT_THAT(copies_of(cut, a), HasSubstr("a is a copy of b, cut off at 1"));
}

TEST(CopiesOf, IsEmptyForTwoEstimates) {
    EXPECT_EQ(copies_of(noise(1), noise(2)), "");
    Picture nearly = noise(1);
    std::swap(nearly.mean[3], nearly.mean[4]);
    EXPECT_EQ(copies_of(noise(1), nearly), "");
}

TEST(CopiesOf, IsEmptyForConstants) {
    const Picture flat = changed(noise(1), [](double) { return 0.5; });
    EXPECT_EQ(copies_of(flat, flat), "");
}

}  // namespace
}  // namespace plumb
