#pragma once

#include "estimators/mis/mis.h"
#include "integrators/paths/path_estimator.h"

namespace plumb {

// Direct light at a vertex, by two techniques that share the work: a direction towards an emitter, and a direction of
// the BSDF that happens to meet one. Both estimate
//   L_direct(wo) = ∫ f(wo, wi) |cos θ| L_e(wi) dω.

/// Finds light for a shading point, says how it arrives and what it counts for. NEE++ and line samples replace a
/// function.
struct NextEvent {
    /// A light and a direction towards it.
    std::optional<SceneLightSample> (*choose)(const Scene&, const PathVertex&, Draws&, std::uint16_t vertex);
    /// An unbiased estimate of how much of it arrives.
    double (*visibility)(const Scene&, const PathVertex&, const EmitterSample&, PathRecord&);
    /// The weight of a technique of density p > 0 against one of density q, one sample each: of the two, weights of
    /// the same direction sum to 1.
    double (*weight)(double p, double q);
};

/// By the power heuristic [Veach 1997, eq. 9.13].
inline double mis_weight(double p, double q) {
    const Power heuristic;
    const double most = std::max(p, q), a = heuristic(p / most), b = heuristic(q / most);
    return a / (a + b);
}

/// Chooses lights by their power, traces a shadow ray, weights by mis_weight().
NextEvent default_next_event();

/// Which techniques find light.
enum class LightTechniques { emitters, bsdf, both };

/// The estimate by a sample of an emitter, over the density of its own numbers, which branch off those of the vertex;
/// weighted against the BSDF's density where both techniques are at work.
Spectrum light_from_emitters(const Scene& scene, const PathVertex& vertex, std::uint16_t number, LightTechniques used,
                             const NextEvent& next_event, const Draws& of_vertex, PathRecord& record);

/// The same by a direction of the BSDF.
Spectrum light_from_bsdf(const Scene& scene, const PathVertex& vertex, std::uint16_t number, LightTechniques used,
                         const NextEvent& next_event, const Draws& of_vertex, PathRecord& record);

}  // namespace plumb
