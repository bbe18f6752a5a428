#include "scenes/emitters/environment_map.h"

#include <fmt/format.h>

#include <numeric>

#include "core/error.h"
#include "estimators/densities/warps.h"
#include "scenes/textures/texels.h"

namespace plumb {

namespace {

std::size_t cell_at(double place, std::size_t cells) {
    return std::min(static_cast<std::size_t>(place * static_cast<double>(cells)), cells - 1);
}

void require_radiances(std::size_t width, std::size_t height, const std::vector<Spectrum>& pixels) {
    if (width == 0 || height == 0 || pixels.size() != width * height)
        throw Error(
            fmt::format("environment map of {} x {} with {} pixels: both sizes must be positive, with a "
                        "spectrum each pixel",
                        width, height, pixels.size()));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (const double value : pixels[i].lane)
            if (!(value >= 0 && std::isfinite(value)))
                throw Error(fmt::format("environment map: pixel ({}, {}) holds {}; accepted are finite numbers >= 0",
                                        i % width, i / width, value));
    if (std::ranges::all_of(pixels, [](const Spectrum& s) { return !(luminance(s) > 0); }))
        throw Error("environment map: every pixel is black; a light needs one that is not");
}

}  // namespace

EnvironmentMap::EnvironmentMap(std::size_t width, std::size_t height, std::vector<Spectrum> pixels, const Frame& frame)
    : width_(width), height_(height), pixels_(std::move(pixels)), frame_(frame) {
    require_radiances(width_, height_, pixels_);
    std::vector<double> row_weights(height_), weights(width_);
    for (std::size_t j = 0; j < height_; ++j) {
        for (std::size_t i = 0; i < width_; ++i) weights[i] = luminance(cell_mean(i, j));
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        row_weights[j] = sum * solid_angle(j);
        if (!(sum > 0)) std::ranges::fill(weights, 1.0);  // a black row is never chosen
        columns_.emplace_back(weights);
    }
    rows_.emplace_back(row_weights);
}

std::optional<LightSample> EnvironmentMap::sample(Vec3, const Point<2>& u) const {
    const double v = rows_[0].sample(u[1]);
    const std::size_t row = cell_at(v, height_);
    const double longitude = columns_[row].sample(u[0]);
    const double down = v * static_cast<double>(height_) - static_cast<double>(row);
    const double cos = (1 - down) * cos_above(row) + down * cos_above(row + 1);
    const double sin = std::sqrt(std::max(0.0, (1 - cos) * (1 + cos))), phi = 2 * pi * longitude;
    return LightSample{.direction = frame_.to_world({sin * std::sin(phi), cos, -sin * std::cos(phi)}),
                       .radiance = lookup({longitude, std::acos(cos) / pi}),
                       .pdf = pdf({cell_at(longitude, width_), row})};
}

std::optional<LightHit> EnvironmentMap::hit(Vec3, Vec3 direction) const {
    const Point<2> uv = place_of(direction);
    return LightHit{.radiance = lookup(uv), .pdf = pdf({cell_at(uv[0], width_), cell_at(uv[1], height_)})};
}

/// ∫ L dω exactly: in longitude the hat function of a pixel has the integral Δφ; in latitude that of row j against
/// sin θ has (2 sin θ_j − sin θ_{j−1} − sin θ_{j+1})/Δθ, and those of the outermost rows, constant up to the pole,
/// 1 − (sin θ_1 − sin θ_0)/Δθ.
Spectrum EnvironmentMap::power(double scene_radius) const {
    const double step = pi / static_cast<double>(height_);
    const double end = height_ == 1 ? 2 : 1 - (std::sin(1.5 * step) - std::sin(0.5 * step)) / step;
    Spectrum sum;
    for (std::size_t j = 0; j < height_; ++j) {
        const double inner = 2 * std::sin((static_cast<double>(j) + 0.5) * step) * (1 - std::cos(step)) / step;
        const double weight = j == 0 || j + 1 == height_ ? end : inner;
        for (std::size_t i = 0; i < width_; ++i) sum += pixels_[j * width_ + i] * weight;
    }
    return sum * (2 * pi / static_cast<double>(width_) * pi * scene_radius * scene_radius);
}

Spectrum EnvironmentMap::lookup(const Point<2>& uv) const {
    const double x = uv[0] * static_cast<double>(width_) - 0.5, y = uv[1] * static_cast<double>(height_) - 0.5;
    const double left = std::floor(x), top = std::floor(y), s = x - left, t = y - top;
    const auto i = static_cast<std::ptrdiff_t>(left), j = static_cast<std::ptrdiff_t>(top);
    return (1 - t) * ((1 - s) * pixel(i, j) + s * pixel(i + 1, j)) +
           t * ((1 - s) * pixel(i, j + 1) + s * pixel(i + 1, j + 1));
}

Point<2> EnvironmentMap::place_of(Vec3 direction) const {
    const Vec3 local = frame_.to_local(direction);
    return {turn_of(-local.z, local.x), std::atan2(std::hypot(local.x, local.z), local.y) / pi};
}

Spectrum EnvironmentMap::pixel(std::ptrdiff_t column, std::ptrdiff_t row) const {
    const auto width = static_cast<std::ptrdiff_t>(width_), height = static_cast<std::ptrdiff_t>(height_);
    const std::ptrdiff_t i = (column % width + width) % width, j = std::clamp<std::ptrdiff_t>(row, 0, height - 1);
    return pixels_[static_cast<std::size_t>(j * width + i)];
}

Spectrum EnvironmentMap::cell_mean(std::size_t column, std::size_t row) const {
    constexpr std::array<double, 3> weight{0.125, 0.75, 0.125};
    Spectrum mean;
    for (std::ptrdiff_t b = -1; b <= 1; ++b)
        for (std::ptrdiff_t a = -1; a <= 1; ++a)
            mean += pixel(static_cast<std::ptrdiff_t>(column) + a, static_cast<std::ptrdiff_t>(row) + b) *
                    (weight[static_cast<std::size_t>(a + 1)] * weight[static_cast<std::size_t>(b + 1)]);
    return mean;
}

double EnvironmentMap::cos_above(std::size_t row) const {
    return std::cos(pi * static_cast<double>(row) / static_cast<double>(height_));
}

double EnvironmentMap::solid_angle(std::size_t row) const {
    return 2 * pi / static_cast<double>(width_) * (cos_above(row) - cos_above(row + 1));
}

double EnvironmentMap::pdf(const Cell& cell) const {
    const auto middle = [](std::size_t i, std::size_t n) {
        return (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    };
    const double probability = rows_[0].pdf(middle(cell.row, height_)) / static_cast<double>(height_) *
                               columns_[cell.row].pdf(middle(cell.column, width_)) / static_cast<double>(width_);
    return probability / solid_angle(cell.row);
}

namespace description {

EnvironmentMap EnvironmentMap::load(Properties& properties) {
    const double scale = properties.number("scale", 1);
    if (!(scale >= 0))
        throw properties.place_of("scale").error(fmt::format("scale is {}; values from 0 are accepted", scale));
    return {properties.file("filename"), scale, properties.transform("to_world")};
}

plumb::EnvironmentMap EnvironmentMap::light() const {
    const Texels texels = read_texels(file);
    std::vector<Spectrum> pixels;
    pixels.reserve(texels.rgb.size() / 3);
    for (int y = 0; y < texels.height; ++y)
        for (int x = 0; x < texels.width; ++x) pixels.push_back(texels.texel(x, y) * scale);
    const auto axis = [&](Vec3 local) { return to_world.vector(local); };
    const Frame frame{axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
    for (const auto& [a, b, product] : {std::tuple{frame.x, frame.x, 1.},
                                        {frame.y, frame.y, 1.},
                                        {frame.z, frame.z, 1.},
                                        {frame.x, frame.y, 0.},
                                        {frame.y, frame.z, 0.},
                                        {frame.z, frame.x, 0.}})
        if (std::abs(dot(a, b) - product) > 1e-5) throw Error("to_world of an envmap: accepted are rotations");
    return {static_cast<std::size_t>(texels.width), static_cast<std::size_t>(texels.height), std::move(pixels), frame};
}

}  // namespace description

}  // namespace plumb
