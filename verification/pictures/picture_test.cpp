#include "verification/pictures/picture.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/test_folder.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Image grey(std::vector<float> values) {
    const int width = static_cast<int>(values.size());
    return {width, 1, {"Y"}, std::move(values)};
}

const std::vector<std::string> names{"p.exr", "q.exr", "r.exr"};

TEST(Picture, TakesItsVarianceFromLayers) {
    const Image image{1, 1, {"A", "variance.Y", "Y"}, {1, 0.25f, 3}, {{"plumb:replicates", "5"}}};
    const Picture picture = picture_of(std::vector{image}, names);
    EXPECT_THAT(picture.mean, ElementsAre(3));
    EXPECT_THAT(picture.variance, ElementsAre(0.25));
    EXPECT_EQ(picture.degrees, 4);
    const Picture two = picture_of(std::vector{image, image}, names);
    EXPECT_THAT(two.variance, ElementsAre(0.125));
    EXPECT_EQ(two.degrees, 8);
}

TEST(Picture, TakesItsVarianceFromTheSpreadOfRenders) {
    const Picture picture = picture_of(std::vector{grey({0, 0}), grey({3, 0}), grey({6, 0})}, names);
    EXPECT_THAT(picture.mean, ElementsAre(3, 0));
    EXPECT_THAT(picture.variance, ElementsAre(3, 0));  // (9 + 0 + 9)/2, over three
    EXPECT_EQ(picture.degrees, 2);
}

TEST(Picture, CountsAndExcludesWhatIsNotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const Picture picture = picture_of(std::vector{grey({1, nan, infinity})}, names, true);
    EXPECT_EQ(picture.bad_pixels, 2U);
    EXPECT_EQ(picture.mean[0], 1);
    EXPECT_TRUE(std::isnan(picture.mean[1]) && std::isnan(picture.mean[2]));
}

TEST(Picture, KnowsHowItsNumbersAreRounded) {
    EXPECT_EQ(picture_of(std::vector{grey({0.5f, 1.0009765625f})}, names, true).rounding, 0x1p-11);
    EXPECT_EQ(picture_of(std::vector{grey({0.1f})}, names, true).rounding, 0x1p-24);
}

TEST(Picture, SaysWhatIsMissing) {
    const auto error = [](const std::vector<Image>& images) {
        return error_of([&] { (void)picture_of(images, names); });
    };
    EXPECT_THAT(error({grey({1})}), HasSubstr("p.exr: one image without layers variance.Y"));
    EXPECT_THAT(error({grey({1}), grey({1, 2})}), HasSubstr("q.exr: is 2x1 pixels, p.exr 1x1"));
    EXPECT_THAT(error({Image{1, 1, {"Y"}, {1}, {}, true}}), HasSubstr("p.exr: stores integers"));
    EXPECT_THAT(error({Image{1, 1, {"Z"}, {1}}}), HasSubstr("p.exr: has channels Z; accepted: R, G and B"));
    EXPECT_THAT(error({Image{1, 1, {"Y", "variance.Y"}, {1, 1}}}), HasSubstr("no attribute plumb:replicates"));
    EXPECT_THAT(error({Image{1, 1, {"Y", "variance.Y"}, {1, 1}, {{"plumb:replicates", "1"}}}}),
                HasSubstr("needs two replicates"));
}

TEST(Picture, IsRefusedWhereItSharesRandomNumbers) {
    Image a = grey({1}), b = grey({2});
    a.metadata = {{"plumb:seed", "7"}, {"plumb:scene_hash", "ab"}};
    b.metadata = {{"plumb:seed", "8"}, {"plumb:scene_hash", "ab"}};
    require_independent(std::vector{a, b, grey({3})}, names);
    b.metadata["plumb:seed"] = "7";
    EXPECT_THAT(error_of([&] {
                    require_independent(std::vector{a, b}, names);
                }),
                HasSubstr("p.exr and q.exr: both have seed 7 and the same scene"));
}

TEST(PictureWithoutError, IsOfOneImageThatDoesNotTellIt) {
    const Image image{2, 1, {"R", "G", "B"}, {1, 2, 3, 4, 5, 6}};
    const Picture picture = picture_without_error(image, "a");
    EXPECT_FALSE(picture.error_known);
    EXPECT_EQ(picture.mean, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(picture.degrees, 0);
    EXPECT_THROW((void)picture_without_error({1, 1, {"A"}, {1}}, "a"), Error);
}

TEST(PictureWithoutError, IsLight) {
    Image image{1, 1, {"Y"}, {0.5F}, {}, true};
    EXPECT_NEAR(picture_without_error(image, "a").mean[0], 0.21404, 1e-5);  // ((0.5 + 0.055)/1.055)^2.4
    image.encoding = {"Gamma2.2", 2.2};
    EXPECT_NEAR(picture_without_error(image, "a").mean[0], std::pow(0.5, 2.2), 1e-6);
    image.encoding = {"linear", 0};
    EXPECT_EQ(picture_without_error(image, "a").mean[0], 0.5);
    image.encoding = {"KodakLog", 0};
    EXPECT_THROW((void)picture_without_error(image, "a"), Error);
}

TEST(Picture, KnowsItsSamplesAndTheErrorOfItsMeans) {
    Image image{1, 1, {"Y", "variance.Y"}, {1, 0.5F}};
    image.metadata = {{"plumb:replicates", "16"}, {"plumb:spp", "64"}, {"plumb:error_of_means", "0.25"}};
    const Picture two = picture_of(std::vector{image, image}, std::vector<std::string>{"a", "b"});
    EXPECT_EQ(two.samples, 128);
    ASSERT_EQ(two.mean_variance.size(), 1U);
    EXPECT_EQ(two.mean_variance[0], 0.25 * 0.25 / 2);
    image.metadata.erase("plumb:error_of_means");
    EXPECT_TRUE(picture_of(std::vector{image}, std::vector<std::string>{"a"}).mean_variance.empty());
}

}  // namespace
}  // namespace plumb
