#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/primary_samples.h"
#include "integrators/paths/path_story.h"

namespace plumb {

/// The pixels that a path is for: film points are drawn uniformly among them, then by the film's filter. A path's
/// values estimate the mean of the pixels, except for splats that fall anywhere on the film.
struct FilmRegion {
    int x = 0, y = 0, width = 1, height = 1;
};

/// A point of a path on a surface, with what scatters there. Its directions leave it, in the world.
struct PathVertex {
    Hit hit;
    Vec3 wo;      ///< where the subpath comes from: towards the sensor, or the light
    Frame frame;  ///< z is the shading normal
    Bsdf bsdf;

    [[nodiscard]] Vec3 to_local(Vec3 world) const { return frame.to_local(world); }
    /// Whether both normals see w on one side.
    [[nodiscard]] bool agree(Vec3 w) const { return dot(hit.point.normal, w) * dot(frame.z, w) > 0; }
    /// Whether both normals see the direction towards the light, wi or wo, on one side. Where they do not, light would
    /// leak through the surface that the shading normal pretends [Veach 1997, section 5.3]: nothing scatters there.
    [[nodiscard]] bool lit(Vec3 wi, Transport transport) const {
        return agree(transport == Transport::radiance ? wi : wo);
    }
};

/// A contribution to the film: value = f w / p, of a path of so many edges (1: a light seen directly).
struct Splat {
    Point<2> film;
    Spectrum value;
    int edges;
    /// Whether the splat is for every pixel j whose filter reaches the film point, whatever the region: h_j(film) value
    /// estimates pixel j, and a driver that traces n such paths takes 1/n of each.
    bool anywhere = false;
};

/// The record of what an estimator did for one sample. It is reused from sample to sample, so that it allocates once.
struct PathRecord {
    std::vector<PathVertex> vertices;        ///< from the sensor on; the sensor itself is not among them
    std::vector<PathVertex> light_vertices;  ///< from a light on, likewise
    std::vector<Splat> splats;
    RayLog rays;  ///< counts on over samples
    /// The weight of what is seen first: its layers average this times a property of the first vertex over the samples.
    double first_hit_weight = 1;
    PathStory* story = nullptr;  ///< of the sample, where somebody listens

    void clear() {
        if (story) story->clear();
        vertices.clear();
        light_vertices.clear();
        splats.clear();
        first_hit_weight = 1;
    }
    /// The gate of all splats: adds the value divided by the density of the numbers that it depends on. The density of
    /// other numbers may be divided out too: the expectation of 1/q under q is 1, so that nothing but the variance
    /// changes.
    void add(const Splat& splat, double density) {
        splats.push_back(splat);
        splats.back().value *= 1 / density;
    }
    /// Adds the next vertex from the sensor, found with numbers of this density.
    PathVertex& meet(const PathVertex& vertex, double density) {
        if (vertices.empty()) first_hit_weight = 1 / density;
        return vertices.emplace_back(vertex);
    }
    /// Tells the story, which must be there, of light that is to be the next splat or a part of it.
    void tell(const PathStory::Finding& finding) const { story->found(finding, splats.size()); }
    /// The sum of the splats for the region.
    [[nodiscard]] Spectrum sum() const {
        Spectrum sum;
        for (const Splat& splat : splats)
            if (!splat.anywhere) sum += splat.value;
        return sum;
    }
};

struct PathShift;  // integrators/paths/shift.h

/// Says what a path is; a driver decides which paths, in which passes. Random numbers come from the slots of
/// PrimarySamples alone, so that any driver may guide, replay or mutate them.
struct PathEstimator {
    virtual ~PathEstimator() = default;
    /// One path for the region: its vertices and splats replace those of the record.
    virtual void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
                       PathRecord& record) const = 0;
    /// The mapping that shifts its paths to other pixels: random replay where it knows none better. The estimator must
    /// outlive what it returns.
    [[nodiscard]] virtual std::unique_ptr<PathShift> shift() const;
};

}  // namespace plumb
