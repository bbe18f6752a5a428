// Writes terrain.ply into a folder: hills of 710 × 710 squares, 1,008,200 triangles, the same bytes everywhere: sums,
// products and an integer hash alone decide the heights.

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "core/file.h"

namespace {

static_assert(std::endian::native == std::endian::little, "the file says binary_little_endian");

constexpr std::uint32_t squares = 710;
constexpr float side = 16;  // of the ground, around the origin

/// A number in [0, 1) for a point of the grid.
double lattice(std::uint32_t x, std::uint32_t y, std::uint32_t octave) {
    std::uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u ^ octave * 0xC2B2AE3Du;
    for (const std::uint32_t factor : {0x7FEB352Du, 0x846CA68Bu}) h = (h ^ h >> 16) * factor;
    return (h >> 8) * 0x1p-24;
}

double smooth(double t) {
    return t * t * (3 - 2 * t);
}

double noise(double x, double y, std::uint32_t octave) {
    const double left = std::floor(x), low = std::floor(y), s = smooth(x - left), t = smooth(y - low);
    const auto i = static_cast<std::uint32_t>(left), j = static_cast<std::uint32_t>(low);
    return (lattice(i, j, octave) * (1 - s) + lattice(i + 1, j, octave) * s) * (1 - t) +
           (lattice(i, j + 1, octave) * (1 - s) + lattice(i + 1, j + 1, octave) * s) * t;
}

/// Ridges 1 − |2n − 1| of eight octaves, each rough where the coarser ones are high, over a valley that runs along z in
/// the middle; x and y in [0, 1].
double height(double x, double y) {
    double sum = 0, size = 1, coarser = 1;
    for (std::uint32_t octave = 0; octave < 8; ++octave, size /= 2) {
        const double ridge = 1 - std::abs(2 * noise(4 * x / size, 4 * y / size, octave) - 1);
        coarser *= ridge;
        sum += size * ridge * coarser;
    }
    const double from_valley = std::abs(x - 0.5) * 2;
    return sum * (0.35 + 1.9 * smooth(from_valley));
}

template <class T>
void append(std::string& bytes, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

void append_vertices(std::string& bytes) {
    for (std::uint32_t j = 0; j <= squares; ++j) {
        for (std::uint32_t i = 0; i <= squares; ++i) {
            const double x = static_cast<double>(i) / squares, y = static_cast<double>(j) / squares;
            append(bytes, static_cast<float>((x - 0.5) * side));
            append(bytes, static_cast<float>(height(x, y)));
            append(bytes, static_cast<float>((y - 0.5) * side));
        }
    }
}

void append_triangle(std::string& bytes, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t index : {a, b, c}) append(bytes, index);
}

std::string terrain() {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        (squares + 1) * (squares + 1), 2 * squares * squares);
    append_vertices(bytes);
    for (std::uint32_t j = 0; j < squares; ++j) {
        for (std::uint32_t i = 0; i < squares; ++i) {
            const std::uint32_t corner = j * (squares + 1) + i, above = corner + squares + 1;
            append_triangle(bytes, corner, above, above + 1);
            append_triangle(bytes, corner, above + 1, corner + 1);
        }
    }
    return bytes;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: {} FOLDER\n", argv[0]);
        return 2;
    }
    plumb::write_file(std::filesystem::path(argv[1]) / "terrain.ply", terrain());
}
