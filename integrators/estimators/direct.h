#pragma once

#include <functional>

#include "integrators/paths/next_event.h"

namespace plumb {

/// What a vertex sends on of the light that reaches it from emitters, over the density of the numbers that it draws for
/// that, beside those of the vertex.
using ReflectedLight = std::function<Spectrum(const Scene&, const PathVertex&, const Draws& of_vertex, PathRecord&)>;

/// A path of at most two edges: light seen directly, and light reflected once, as `reflected` estimates it.
void trace_two_edges(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record,
                     const ReflectedLight& reflected);

/// Direct illumination: paths of at most two edges, sensor – surface – emitter, by samples of emitters, of BSDFs, or
/// of both with multiple importance sampling [Veach & Guibas 1995].
struct Direct final : PathEstimator {
    LightTechniques used = LightTechniques::both;
    NextEvent next_event = default_next_event();

    Direct() = default;
    explicit Direct(LightTechniques techniques, const NextEvent& parts = default_next_event())
        : used(techniques), next_event(parts) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

}  // namespace plumb
