// Meshes of a million triangles from files to what a scene keeps: normals added, transformed.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/file.h"
#include "scenes/description/mesh.h"
#include "scenes/description/obj.h"
#include "scenes/description/ply.h"

namespace plumb {
namespace {

constexpr std::uint32_t side = 708;  // 2 · 707² = 999,698 triangles

std::array<float, 3> vertex(std::uint32_t i, std::uint32_t j) {
    const float x = static_cast<float>(i) / side, y = static_cast<float>(j) / side;
    return {x, y, 0.1f * std::sin(20 * x) * std::cos(30 * y)};
}

template <class Put>
void for_each_triangle(const Put& put) {
    for (std::uint32_t i = 0; i + 1 < side; ++i)
        for (std::uint32_t j = 0; j + 1 < side; ++j) {
            const std::uint32_t a = i * side + j, b = a + side;
            put(a, b, b + 1);
            put(a, b + 1, a + 1);
        }
}

std::string ply_header(std::string_view format) {
    return fmt::format(
        "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        format, side * side, 2 * (side - 1) * (side - 1));
}

std::string binary_ply() {
    std::string text = ply_header("binary_little_endian");
    const auto put = [&](const auto& value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (std::uint32_t v = 0; v < side * side; ++v) put(vertex(v / side, v % side));
    for_each_triangle([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        text += '\3';
        put(std::array{a, b, c});
    });
    return text;
}

std::string ascii_ply() {
    std::string text = ply_header("ascii");
    for (std::uint32_t v = 0; v < side * side; ++v) {
        const auto [x, y, z] = vertex(v / side, v % side);
        fmt::format_to(std::back_inserter(text), "{} {} {}\n", x, y, z);
    }
    for_each_triangle([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", a, b, c);
    });
    return text;
}

std::string obj() {
    std::string text;
    for (std::uint32_t v = 0; v < side * side; ++v) {
        const auto [x, y, z] = vertex(v / side, v % side);
        fmt::format_to(std::back_inserter(text), "v {} {} {}\n", x, y, z);
    }
    for_each_triangle([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", a + 1, b + 1, c + 1);
    });
    return text;
}

template <class Read>
void load(benchmark::State& state, const std::string& text, const Read& read) {
    const auto file = std::filesystem::temp_directory_path() / fmt::format("plumb_mesh_bench_{}", getpid());
    write_file(file, text);
    for (auto _ : state) {
        Mesh mesh = read(file);
        add_smooth_normals(mesh);
        benchmark::DoNotOptimize(transformed(std::move(mesh), Transform::translate({1, 2, 3})));
    }
    std::filesystem::remove(file);
}

void million_triangles_binary_ply(benchmark::State& state) {
    load(state, binary_ply(), read_ply);
}
BENCHMARK(million_triangles_binary_ply)->Unit(benchmark::kMillisecond);

void million_triangles_ascii_ply(benchmark::State& state) {
    load(state, ascii_ply(), read_ply);
}
BENCHMARK(million_triangles_ascii_ply)->Unit(benchmark::kMillisecond);

void million_triangles_obj(benchmark::State& state) {
    load(state, obj(), read_obj);
}
BENCHMARK(million_triangles_obj)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
