#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/images/image.h"
#include "core/spectrum.h"
#include "scenes/film/exact_sum.h"
#include "scenes/film/film_size.h"
#include "scenes/film/wide_sum.h"

namespace plumb {

/// A part of a picture that a film records under one name: three channels, or one.
struct FilmLayer {
    std::string name;
    std::vector<std::string> channels;  ///< e.g. R, G, B; X, Y, Z; Z
    bool non_negative = true;           ///< then negative values are counted
    /// Sums are in units of 2^exponent, which ought to be of the size of the picture's mean: they resolve 2^-64 of it.
    int exponent = 0;
};

/// Counts of values that should not be, or seldom. NaN and infinite ones add nothing to a pixel; negative ones do add,
/// and so do large ones, of 2^31 units and more, as exactly as others: a film that drops them is biased.
struct BadValues {
    std::uint64_t nan = 0, infinite = 0, negative = 0, large = 0;
    void merge(const BadValues& other);
    friend bool operator==(const BadValues&, const BadValues&) = default;
};

/// One replicate of an image: sums over its samples, which do not depend on their order.
class FilmPass {
public:
    FilmPass(FilmSize size, std::vector<FilmLayer> layers);

    /// Adds one sample of a pixel: the layers' values in their order, as many lanes of each as it has channels.
    void add(int x, int y, std::span<const Spectrum> values);
    /// Adds `count` samples of a pixel that bring nothing to any layer.
    void add_black(int x, int y, std::uint64_t count) { samples_[pixel(x, y)] += count; }
    /// Adds light that the path of another pixel's sample brings to this one to the sum of the first layer. The value
    /// is divided already by the number of paths that bring some for each sample of the pixel.
    void splat(int x, int y, const Spectrum& value);
    /// Adds samples that other threads or shards took for the same replicate.
    void merge(const FilmPass& other);
    /// Adds a part of the image, its upper left corner at pixel (x, y).
    void merge_at(int x, int y, const FilmPass& part);

    [[nodiscard]] std::uint64_t samples(int x, int y) const { return samples_[pixel(x, y)]; }
    [[nodiscard]] double mean(int x, int y, std::size_t channel) const;
    [[nodiscard]] const BadValues& bad_values() const { return bad_; }
    [[nodiscard]] std::size_t channels() const { return channels_; }
    [[nodiscard]] FilmSize size() const { return size_; }
    [[nodiscard]] const std::vector<FilmLayer>& layers() const { return layers_; }

private:
    friend class Film;
    [[nodiscard]] std::size_t pixel(int x, int y) const;
    [[nodiscard]] double mean_at(std::size_t pixel, std::size_t channel) const;  // in units of its layer
    void add_to(std::size_t first_sum, const FilmLayer& layer, const Spectrum& value);

    FilmSize size_;
    std::vector<FilmLayer> layers_;
    std::size_t channels_;
    std::vector<ExactSum> sums_;  // pixel by pixel, channel by channel
    WideSums wide_;               // of large values, by the same numbers
    std::vector<std::uint64_t> samples_;
    BadValues bad_;
};

/// An image from independent replicates: the mean of their means, and its variance from their spread, which is right
/// for stratified, quasi-random, splatted and Markov samples alike (the variance from squares of single samples is
/// not). Replicates in any order, from any shard, give the same bits.
class Film {
public:
    Film(FilmSize size, std::vector<FilmLayer> layers);

    /// Adds a finished replicate. A pixel without samples in it counts as black there.
    void add(const FilmPass& pass);
    void merge(const Film& other);

    [[nodiscard]] std::uint64_t replicates() const { return replicates_; }
    [[nodiscard]] std::uint64_t samples(int x, int y) const;
    [[nodiscard]] double mean(int x, int y, std::size_t channel) const;
    /// The variance of the mean of a channel of the first layer; infinite for fewer than two replicates.
    [[nodiscard]] double variance_of_mean(int x, int y, std::size_t channel) const;
    /// The variance of the mean over all pixels of a channel of the first layer, by the replicates' own such means:
    /// right whatever the errors of pixels have in common. Infinite for fewer than two replicates.
    [[nodiscard]] double variance_of_picture_mean(std::size_t channel) const;
    [[nodiscard]] const BadValues& bad_values() const { return bad_; }
    [[nodiscard]] FilmSize size() const { return size_; }
    [[nodiscard]] const std::vector<FilmLayer>& layers() const { return layers_; }

    /// The picture: channels R, G, B of the first layer, `variance.R` … of its mean, `samples`, then `layer.channel` of
    /// the others.
    [[nodiscard]] Image image() const;

private:
    friend struct FilmBits;  // of film_part.cpp
    [[nodiscard]] std::size_t pixel(int x, int y) const;
    void add_mean(std::size_t pixel, std::size_t channel, double mean);
    [[nodiscard]] std::size_t square_of(std::size_t pixel, std::size_t channel) const;
    [[nodiscard]] double mean_at(std::size_t pixel, std::size_t channel) const;  // in units of its layer
    [[nodiscard]] double variance_at(std::size_t pixel, std::size_t channel) const;

    FilmSize size_;
    std::vector<FilmLayer> layers_;
    std::size_t channels_;
    std::vector<ExactSum> sums_;  // pixel by pixel, channel by channel; after the last pixel the means over all
    std::vector<ExactSumOfSquares> squares_;  // of the first layer
    WideSums wide_sums_, wide_squares_;       // of large values, by the same numbers
    std::vector<std::uint64_t> samples_;
    std::uint64_t replicates_ = 0;
    BadValues bad_;
};

}  // namespace plumb
