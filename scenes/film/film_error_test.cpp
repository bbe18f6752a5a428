#include "scenes/film/film_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace plumb {
namespace {

// The second layer has nothing to say.
const std::vector<FilmLayer> layers{{"radiance", {"R", "G", "B"}}, {"depth", {"Z"}, false}};

FilmPass pass_of(const std::vector<Spectrum>& pixels) {
    FilmPass pass({static_cast<int>(pixels.size()), 1}, layers);
    for (int x = 0; x < pass.size().width; ++x)
        pass.add(x, 0, std::vector{pixels[static_cast<std::size_t>(x)], Spectrum::grey(100.0 * x)});
    return pass;
}

TEST(FilmError, OfThreeReplicates) {
    Film film({2, 1}, layers);
    film.add(pass_of({Spectrum::rgb(2, 0, 5), Spectrum::grey(1)}));
    EXPECT_EQ(error_of(film).rmse, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error_of(film).relative, std::numeric_limits<double>::infinity());
    film.add(pass_of({Spectrum::rgb(3, 3, 5), Spectrum::grey(1)}));
    film.add(pass_of({Spectrum::rgb(4, 6, 5), Spectrum::grey(1)}));
    // Spreads 1, 9, 0 and thrice 0, of means 3, 3, 5 and thrice 1.
    const double v = 10.0 / 3, squares = 9 + 9 + 25 + 3;
    EXPECT_NEAR(error_of(film).rmse, std::sqrt(v / 6), 1e-12);
    EXPECT_NEAR(error_of(film).relative, std::sqrt(v / (squares - v)), 1e-12);
}

/// Whatever pixels have in common: here errors that cancel in red, and that are the same in green.
TEST(FilmError, OfMeansIsThatOfTheReplicatesMeans) {
    Film film({2, 1}, layers), other({2, 1}, layers), merged({2, 1}, layers);
    EXPECT_EQ(error_of(film).of_means, std::vector<double>(3, std::numeric_limits<double>::infinity()));
    for (const double e : {-3.0, 0.0, 3.0}) {
        const FilmPass pass = pass_of({Spectrum::rgb(8 + e, 8 + e, 5), Spectrum::rgb(8 - e, 8 + e, 5)});
        film.add(pass);
        (e < 0 ? merged : other).add(pass);
    }
    merged.merge(other);
    for (const Film& of : {film, merged}) {
        const std::vector<double> errors = error_of(of).of_means;
        ASSERT_EQ(errors.size(), 3U);
        EXPECT_EQ(errors[0], 0);
        EXPECT_NEAR(errors[1], std::sqrt(9.0 / 3), 1e-12);
        EXPECT_EQ(errors[2], 0);
    }
    EXPECT_EQ(film.variance_of_picture_mean(1), merged.variance_of_picture_mean(1));
}

TEST(FilmError, WithoutNoiseOrWithoutAnythingElse) {
    Film black({1, 1}, layers), noise({1, 1}, layers);
    for (const double value : {-1.0, 1.0}) {
        black.add(pass_of({Spectrum{}}));
        noise.add(pass_of({Spectrum::grey(value)}));
    }
    EXPECT_EQ(error_of(black).relative, 0);
    EXPECT_EQ(error_of(noise).relative, std::numeric_limits<double>::infinity());
}

/// A sample is twice its pixel's radiance with probability ½, else 0: n samples have the relative error 1/√n, whatever
/// the radiances. 4096 pixels of 16 replicates tell the variance to √(2/15/4096·⟨L⁴⟩/⟨L²⟩²): 0.8 %, its root to 0.4 %.
TEST(FilmError, IsTheClosedFormOfCoins) {
    constexpr int side = 64, samples = 4, replicates = 16;
    Film film({side, side}, layers);
    RandomStream random(stream_id("coins"));
    for (int r = 0; r < replicates; ++r) {
        FilmPass pass({side, side}, layers);
        for (int i = 0; i < side * side * samples; ++i) {
            const int x = i % side, y = i / side % side;
            const double radiance = 1 + x / 63.0;
            pass.add(x, y, std::vector{Spectrum::grey(random.uniform() < 0.5 ? 0 : 2 * radiance), Spectrum{}});
        }
        film.add(pass);
    }
    EXPECT_NEAR(error_of(film).relative, 1 / std::sqrt(samples * replicates), 5 * 0.004 / 8);
}

// Each of `spikes` pixels of 100 has one value of 1000 beside so many zeros; all have some regular noise.
Film with_spikes(int spikes, int passes, std::uint64_t seed) {
    Film film({100, 1}, layers);
    RandomStream random(seed);
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<Spectrum> pixels;
        for (int x = 0; x < 100; ++x)
            pixels.push_back(Spectrum::grey(pass == x % passes && x < spikes ? 1000 : random.uniform()));
        film.add(pass_of(pixels));
    }
    return film;
}

TEST(ErrorOfVariance, IsOneOverTheRootOfTheSpikes) {
    const Film regular = with_spikes(0, 16, 2);
    EXPECT_NEAR(error_of_variance(with_spikes(0, 16, 1), regular), std::sqrt(0.8 / 32 / 100), 0.004);
    for (const int spikes : {1, 4, 16, 64})
        EXPECT_NEAR(error_of_variance(with_spikes(spikes, 16, 1), regular), 1 / std::sqrt(spikes), 0.01) << spikes;
}

TEST(ErrorOfVariance, OfHalvesThatCannotTell) {
    Film one({1, 1}, layers), other({1, 1}, layers);
    for (const double value : {1.0, 2.0}) one.add(pass_of({Spectrum::grey(value)}));
    other.add(pass_of({Spectrum::grey(1)}));
    EXPECT_EQ(error_of_variance(one, other), std::numeric_limits<double>::infinity());
    other.add(pass_of({Spectrum::grey(1)}));
    EXPECT_EQ(error_of_variance(other, other), 0);
    EXPECT_EQ(error_of_variance(one, one), 0);
}

}  // namespace
}  // namespace plumb
