#pragma once

#include <memory>
#include <optional>
#include <span>

#include "scenes/geometry/shape.h"

namespace plumb {

/// Visibility among shapes: triangles by Embree in robust mode, spheres, disks and wide triangles
/// (scenes/geometry/wide_triangles.h) in doubles, exactly for the given ray.
/// Rays come from leave(), connect() or rounded_ray(), so that Embree sees the numbers from which the hit is computed.
/// No other file calls Embree. Threads may trace at the same time; the same ray gives the same bits.
class EmbreeScene {
public:
    /// The shapes must outlive the scene. Throws Error for a mesh whose indices or coordinates are not its own.
    explicit EmbreeScene(std::span<const description::Shape> shapes);
    ~EmbreeScene();
    EmbreeScene(EmbreeScene&&) noexcept;
    EmbreeScene& operator=(EmbreeScene&&) noexcept;

    /// The nearest hit within (0, t_max).
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const;
    /// Whether anything lies on the open segment.
    [[nodiscard]] bool occluded(const Ray& ray) const;

    /// How many of the rays meet anything: Embree alone, with nothing made of its hits, for benchmarks to compare with.
    [[nodiscard]] std::uint64_t count_hits(std::span<const TracedRay> rays) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace plumb
