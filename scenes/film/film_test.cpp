#include "scenes/film/film.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/random.h"

namespace plumb {
namespace {

const std::vector<FilmLayer> layers{{"radiance", {"R", "G", "B"}}, {"depth", {"Z"}, false}};

FilmPass pass_of(std::initializer_list<double> radiances) {
    FilmPass pass({1, 1}, layers);
    for (const double radiance : radiances) pass.add(0, 0, std::vector{Spectrum::grey(radiance), Spectrum::grey(-2)});
    return pass;
}

std::string bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ExactSum, KeepsWhatDoublesLose) {
    ExactSum sum;
    sum.add(1e9);
    for (int i = 0; i < 1000; ++i) sum.add(0x1p-60);
    sum.add(-1e9);
    EXPECT_EQ(sum.value(), 1000 * 0x1p-60);
    EXPECT_FALSE(ExactSum::accepts(NAN));
    EXPECT_FALSE(ExactSum::accepts(0x1p31));
    EXPECT_TRUE(ExactSum::accepts(-0x1p30));
}

TEST(Film, TakesTheVarianceFromReplicates) {
    Film film({1, 1}, layers);
    film.add(pass_of({1, 3}));
    EXPECT_EQ(film.variance_of_mean(0, 0, 0), std::numeric_limits<double>::infinity());
    film.add(pass_of({2, 4}));
    film.add(pass_of({4, 4}));
    EXPECT_DOUBLE_EQ(film.mean(0, 0, 0), 3);
    EXPECT_NEAR(film.variance_of_mean(0, 0, 0), 2.0 / 2 / 3, 1e-12);  // means 2, 3, 4: spread 1, over 3
    EXPECT_EQ(film.samples(0, 0), 6u);
    EXPECT_EQ(film.mean(0, 0, 3), -2);
}

TEST(Film, FindsNoVarianceInConstants) {
    for (const double constant : {0.1, 0.7, 2.3, 1e5 / 3}) {
        Film film({1, 1}, layers);
        for (int pass = 0; pass < 16; ++pass) film.add(pass_of({constant}));
        EXPECT_EQ(film.variance_of_mean(0, 0, 0), 0) << constant;
    }
}

TEST(Film, CountsWhatShouldNotBe) {
    const FilmPass pass = pass_of({NAN, HUGE_VAL, -1, 1e30, 3});
    EXPECT_EQ(pass.bad_values(), (BadValues{3, 3, 3, 3}));  // three channels each; a depth may be negative
    EXPECT_EQ(pass.samples(0, 0), 5u);
    EXPECT_DOUBLE_EQ(pass.mean(0, 0, 0), (1e30 + 2) / 5);
}

TEST(Film, KeepsLargeValuesInTheirPixel) {
    FilmPass part({2, 1}, layers);
    part.add(1, 0, std::vector{Spectrum::rgb(1, 0x1p40, 3), Spectrum::grey(-0x1p50)});
    FilmPass pass({3, 2}, layers);
    pass.merge_at(1, 1, part);
    EXPECT_EQ(pass.mean(2, 1, 1), 0x1p40);
    EXPECT_EQ(pass.mean(2, 1, 3), -0x1p50);
    EXPECT_EQ(pass.mean(1, 1, 1), 0);
    Film film({3, 2}, layers);
    film.add(pass);
    film.add(FilmPass({3, 2}, layers));
    EXPECT_EQ(film.mean(2, 1, 1), 0x1p39);
    EXPECT_EQ(film.variance_of_mean(2, 1, 1), 0x1p78);  // of means 2^40 and 0: spread 2^79, over 2
    EXPECT_EQ(film.bad_values(), (BadValues{0, 0, 0, 2}));
}

TEST(Film, IsTheSameInAnyUnit) {
    const auto film_of = [](int exponent) {
        std::vector<FilmLayer> scaled = layers;
        scaled[0].exponent = exponent;
        Film film({1, 1}, scaled);
        for (const double radiance : {0.3, 0.7, 1e-9, 5.1}) {
            FilmPass pass({1, 1}, scaled);
            pass.add(0, 0, std::vector{Spectrum::grey(std::ldexp(radiance, exponent)), Spectrum::grey(-2)});
            film.add(pass);
        }
        return film;
    };
    const Film film = film_of(0);
    for (const int exponent : {-300, -100, 100, 300}) {
        const Film other = film_of(exponent);
        EXPECT_EQ(other.mean(0, 0, 0), std::ldexp(film.mean(0, 0, 0), exponent));
        EXPECT_EQ(other.variance_of_mean(0, 0, 0), std::ldexp(film.variance_of_mean(0, 0, 0), 2 * exponent));
        EXPECT_EQ(other.mean(0, 0, 3), -2);
        EXPECT_THROW(Film(film).merge(other), Error);
    }
    const Image dim = film_of(-100).image();  // whose variance no float holds
    EXPECT_GT(dim.values[3], 0);
}

TEST(Film, IsUncertainOfWhatIsTooLargeToSquare) {
    Film film({1, 1}, layers);
    film.add(pass_of({1e200}));
    film.add(pass_of({2e200}));
    EXPECT_DOUBLE_EQ(film.mean(0, 0, 0), 1.5e200);
    EXPECT_EQ(film.variance_of_mean(0, 0, 0), std::numeric_limits<double>::infinity());
}

TEST(Film, RefusesOtherShapes) {
    EXPECT_THROW(Film({0, 3}, layers), Error);
    EXPECT_THROW(Film({1, 1}, {}), Error);
    EXPECT_THROW(Film({2, 1}, layers).add(pass_of({1})), Error);
    EXPECT_THROW(FilmPass({1, 1}, layers).add(1, 0, std::vector<Spectrum>(2)), Error);
    EXPECT_THROW(FilmPass({1, 1}, layers).add(0, 0, std::vector<Spectrum>(1)), Error);
}

TEST(ImageFile, KeepsChannelsAndTheSameBytes) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "plumb_film_test";
    std::filesystem::create_directories(folder);
    Film film({1, 1}, layers);
    film.add(pass_of({1, 3}));
    film.add(pass_of({2, 2.5}));
    Image image = film.image();
    image.metadata["plumb:seed"] = "42";
    write_image((folder / "a.exr").string(), image);
    write_image((folder / "b.exr").string(), image);
    EXPECT_EQ(bytes(folder / "a.exr"), bytes(folder / "b.exr"));
    const Image read = read_image((folder / "a.exr").string());
    ASSERT_EQ(read.channels.size(), image.channels.size());
    for (std::size_t i = 0; i < image.channels.size(); ++i) {
        const auto found = std::ranges::find(read.channels, image.channels[i]);
        ASSERT_NE(found, read.channels.end()) << image.channels[i];
        EXPECT_EQ(read.values[static_cast<std::size_t>(found - read.channels.begin())], image.values[i]);
    }
    EXPECT_EQ(read.metadata.at("plumb:seed"), "42");
    EXPECT_THROW(write_image((folder / "a.exr" / "b.exr").string(), image), Error);
    EXPECT_THROW(write_image((folder / "a.nonsense").string(), image), Error);
    EXPECT_THROW(static_cast<void>(read_image((folder / "missing.exr").string())), Error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);  // nothing half-written
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace plumb
