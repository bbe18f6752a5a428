#pragma once

#include <functional>

#include "integrators/paths/next_event.h"

namespace plumb {

/// What a vertex sends on of the light that reaches it from lights, over the density of the numbers that it draws for
/// that, beside those of the vertex.
using ReflectedLight = std::function<Spectrum(const Scene&, const PathVertex&, const Draws& of_vertex, PathRecord&)>;

/// A path of at most two edges: light seen directly, and light reflected once, as `reflected` estimates it.
void trace_two_edges(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record,
                     const ReflectedLight& reflected);

/// Direct illumination: paths of at most two edges, sensor – surface – light, by samples of lights, of BSDFs, or
/// of both with multiple importance sampling [Veach & Guibas 1995].
struct Direct final : PathEstimator {
    NextEvent next_event;

    Direct() = default;
    explicit Direct(const NextEvent& parts) : next_event(parts) {}
    explicit Direct(const TechniqueCounts& counts, const NextEvent& parts = {})
        : next_event(with_counts(parts, counts)) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

}  // namespace plumb
