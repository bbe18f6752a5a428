#include "scenes/film/film.h"

#include <fmt/format.h>

#include <limits>

#include "core/error.h"

namespace plumb {

namespace {

std::size_t channels_of(const std::vector<FilmLayer>& layers) {
    std::size_t count = 0;
    for (const FilmLayer& layer : layers) {
        if (layer.channels.empty() || layer.channels.size() > 4)
            throw Error(
                fmt::format("film layer '{}' has {} channels; accepted are 1 to 4", layer.name, layer.channels.size()));
        count += layer.channels.size();
    }
    if (count == 0) throw Error("film without a layer: at least one is needed");
    return count;
}

std::size_t area(FilmSize size) {
    if (size.width < 1 || size.height < 1)
        throw Error(fmt::format("film of {} x {} pixels: both must be at least 1", size.width, size.height));
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

template <class A, class B>
void require_same_shape(const A& a, const B& b) {
    if (a.width != b.width || a.height != b.height)
        throw Error(
            fmt::format("films of {} x {} and {} x {} pixels cannot be joined", a.width, a.height, b.width, b.height));
}

void require_same_channels(std::size_t a, std::size_t b) {
    if (a != b) throw Error(fmt::format("films of {} and {} channels cannot be joined", a, b));
}

// Films whose sums are in other units, or of other layers, are of other pictures.
void require_same_layers(const std::vector<FilmLayer>& a, const std::vector<FilmLayer>& b) {
    if (a.size() != b.size())
        throw Error(fmt::format("films of {} and {} layers cannot be joined", a.size(), b.size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
        require_same_channels(a[i].channels.size(), b[i].channels.size());
        if (a[i].exponent != b[i].exponent)
            throw Error(fmt::format("films with sums of '{}' in units of 2^{} and 2^{} cannot be joined", a[i].name,
                                    a[i].exponent, b[i].exponent));
    }
}

// The exponent of the unit of a channel, counted through all layers.
int exponent_of(const std::vector<FilmLayer>& layers, std::size_t channel) {
    std::size_t i = 0;
    while (channel >= layers[i].channels.size()) channel -= layers[i++].channels.size();
    return layers[i].exponent;
}

// A variance that a float is too coarse for becomes the least that it holds well: to say 0 would be to say that the
// mean is exact.
double variance_for_float(double variance) {
    return variance > 0 ? std::max<double>(variance, std::numeric_limits<float>::min()) : variance;
}

template <class Sums>
void merge_all(Sums& sums, const Sums& others) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].merge(others[i]);
}

}  // namespace

void BadValues::merge(const BadValues& other) {
    nan += other.nan;
    infinite += other.infinite;
    negative += other.negative;
    large += other.large;
}

FilmPass::FilmPass(FilmSize size, std::vector<FilmLayer> layers)
    : size_(size),
      layers_(std::move(layers)),
      channels_(channels_of(layers_)),
      sums_(area(size) * channels_),
      samples_(area(size)) {}

std::size_t FilmPass::pixel(int x, int y) const {
    if (x < 0 || y < 0 || x >= size_.width || y >= size_.height)
        throw Error(fmt::format("pixel ({}, {}) of a film of {} x {}", x, y, size_.width, size_.height));
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x);
}

void FilmPass::add(int x, int y, std::span<const Spectrum> values) {
    if (values.size() != layers_.size())
        throw Error(fmt::format("{} values for a film of {} layers", values.size(), layers_.size()));
    const std::size_t place = pixel(x, y);
    ++samples_[place];
    std::size_t sum = place * channels_;
    for (std::size_t i = 0; i < layers_.size(); sum += layers_[i++].channels.size()) add_to(sum, layers_[i], values[i]);
}

void FilmPass::splat(int x, int y, const Spectrum& value) {
    add_to(pixel(x, y) * channels_, layers_[0], value);
}

void FilmPass::add_to(std::size_t first_sum, const FilmLayer& layer, const Spectrum& value) {
    const double units = layer.exponent == 0 ? 1 : std::ldexp(1.0, -layer.exponent);
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
        if (layer.non_negative && value[c] < 0) ++bad_.negative;
        const double in_units = value[c] * units;
        if (ExactSum::accepts(in_units)) {
            sums_[first_sum + c].add(in_units);
        } else if (std::isfinite(in_units)) {
            ++bad_.large;
            wide_.add(first_sum + c, in_units);
        } else {
            ++(std::isnan(in_units) ? bad_.nan : bad_.infinite);
        }
    }
}

void FilmPass::merge(const FilmPass& other) {
    require_same_shape(size_, other.size_);
    require_same_layers(layers_, other.layers_);
    merge_all(sums_, other.sums_);
    wide_.merge(other.wide_);
    for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i] += other.samples_[i];
    bad_.merge(other.bad_);
}

void FilmPass::merge_at(int x, int y, const FilmPass& part) {
    require_same_layers(layers_, part.layers_);
    for (int j = 0; j < part.size_.height; ++j)
        for (int i = 0; i < part.size_.width; ++i) {
            const std::size_t to = pixel(x + i, y + j), from = part.pixel(i, j);
            samples_[to] += part.samples_[from];
            for (std::size_t c = 0; c < channels_; ++c)
                sums_[to * channels_ + c].merge(part.sums_[from * channels_ + c]);
        }
    for (const auto& [number, sum] : part.wide_.sums()) {
        const auto at = static_cast<int>(number / channels_), width = part.size_.width;
        wide_.merge(pixel(x + at % width, y + at / width) * channels_ + number % channels_, sum);
    }
    bad_.merge(part.bad_);
}

double FilmPass::mean_at(std::size_t pixel, std::size_t channel) const {
    if (samples_[pixel] == 0) return 0;
    const std::size_t number = pixel * channels_ + channel;
    return wide_.total(number, sums_[number]) / static_cast<double>(samples_[pixel]);
}

double FilmPass::mean(int x, int y, std::size_t channel) const {
    return std::ldexp(mean_at(pixel(x, y), channel), exponent_of(layers_, channel));
}

Film::Film(FilmSize size, std::vector<FilmLayer> layers)
    : size_(size),
      layers_(std::move(layers)),
      channels_(channels_of(layers_)),
      sums_((area(size) + 1) * channels_),
      squares_((area(size) + 1) * layers_[0].channels.size()),
      samples_(area(size)) {}

std::size_t Film::pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x);
}
std::size_t Film::square_of(std::size_t pixel, std::size_t channel) const {
    return pixel * layers_[0].channels.size() + channel;
}

void Film::add(const FilmPass& pass) {
    require_same_shape(size_, pass.size());
    require_same_layers(layers_, pass.layers());
    std::vector<double> totals(channels_);
    for (std::size_t pixel = 0; pixel < samples_.size(); ++pixel) {
        samples_[pixel] += pass.samples_[pixel];
        for (std::size_t c = 0; c < channels_; ++c) {
            const double mean = pass.mean_at(pixel, c);
            add_mean(pixel, c, mean);
            totals[c] += mean;
        }
    }
    const auto pixels = static_cast<double>(samples_.size());
    for (std::size_t c = 0; c < channels_; ++c) add_mean(samples_.size(), c, totals[c] / pixels);
    ++replicates_;
    bad_.merge(pass.bad_values());
}

void Film::add_mean(std::size_t pixel, std::size_t channel, double mean) {
    const auto add_to = [](auto& sums, WideSums& wide, std::size_t number, double value) {
        if (sums[number].accepts(value))
            sums[number].add(value);
        else
            wide.add(number, value);
    };
    add_to(sums_, wide_sums_, pixel * channels_ + channel, mean);
    if (channel < layers_[0].channels.size()) add_to(squares_, wide_squares_, square_of(pixel, channel), mean * mean);
}

void Film::merge(const Film& other) {
    require_same_shape(size_, other.size_);
    require_same_layers(layers_, other.layers_);
    merge_all(sums_, other.sums_);
    merge_all(squares_, other.squares_);
    wide_sums_.merge(other.wide_sums_);
    wide_squares_.merge(other.wide_squares_);
    for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i] += other.samples_[i];
    replicates_ += other.replicates_;
    bad_.merge(other.bad_);
}

std::uint64_t Film::samples(int x, int y) const {
    return samples_[pixel(x, y)];
}

double Film::mean_at(std::size_t pixel, std::size_t channel) const {
    if (replicates_ == 0) return 0;
    const std::size_t number = pixel * channels_ + channel;
    return wide_sums_.total(number, sums_[number]) / static_cast<double>(replicates_);
}

double Film::mean(int x, int y, std::size_t channel) const {
    return std::ldexp(mean_at(pixel(x, y), channel), exponent_of(layers_, channel));
}

double Film::variance_of_mean(int x, int y, std::size_t channel) const {
    return variance_at(pixel(x, y), channel);
}

double Film::variance_of_picture_mean(std::size_t channel) const {
    return variance_at(samples_.size(), channel);
}

double Film::variance_at(std::size_t pixel, std::size_t channel) const {
    if (channel >= layers_[0].channels.size())
        throw Error(fmt::format("the variance of channel {}; accepted are the {} of layer '{}'", channel,
                                layers_[0].channels.size(), layers_[0].name));
    if (replicates_ < 2) return std::numeric_limits<double>::infinity();
    const double n = static_cast<double>(replicates_), m = mean_at(pixel, channel);
    const std::size_t number = square_of(pixel, channel);
    const double square = wide_squares_.total(number, squares_[number]) / n, centred = square - m * m;
    if (!std::isfinite(centred)) return std::numeric_limits<double>::infinity();
    // What rounding leaves of a constant is no variance: of each mean and each square when it was added, and of both
    // terms here.
    const double rounding = 2 * std::abs(m) * ExactSum::resolution + ExactSumOfSquares::resolution +
                            4 * std::numeric_limits<double>::epsilon() * square;
    return centred > rounding ? std::ldexp(centred / (n - 1), 2 * layers_[0].exponent) : 0;
}

Image Film::image() const {
    Image image{size_.width, size_.height, {}, {}};
    const std::size_t first = layers_[0].channels.size();
    for (const std::string& channel : layers_[0].channels) image.channels.push_back(channel);
    for (const std::string& channel : layers_[0].channels) image.channels.push_back("variance." + channel);
    image.channels.emplace_back("samples");
    for (std::size_t i = 1; i < layers_.size(); ++i)
        for (const std::string& channel : layers_[i].channels)
            image.channels.push_back(layers_[i].name + "." + channel);
    for (int y = 0; y < size_.height; ++y)
        for (int x = 0; x < size_.width; ++x) {
            const auto put = [&](double value) { image.values.push_back(static_cast<float>(value)); };
            for (std::size_t c = 0; c < first; ++c) put(mean(x, y, c));
            for (std::size_t c = 0; c < first; ++c) put(variance_for_float(variance_of_mean(x, y, c)));
            put(static_cast<double>(samples(x, y)));
            for (std::size_t c = first; c < channels_; ++c) put(mean(x, y, c));
        }
    return image;
}

}  // namespace plumb
