#pragma once

#include <optional>

#include "integrators/next_event.h"

namespace plumb {

/// Which paths are estimated. Edges count from the sensor: 1 is an emitter seen directly, 2 direct light.
struct PathLimits {
    int max_edges = -1;                     ///< longer paths count as black; -1: none is too long
    int roulette_edges = 5;                 ///< paths of as many edges may end by Russian roulette
    int length = 0;                         ///< only paths of so many edges; 0: of all
    std::optional<Strategy> strategy = {};  ///< of `bdpt`: this one alone, unweighted

    [[nodiscard]] bool allow(int edges) const { return max_edges < 0 || edges <= max_edges; }
};

/// Slots number the vertices of one subpath up to here; a path of so many edges carries nothing that a double can tell.
constexpr int last_vertex = 0x7ff0;

/// Probability with which a path goes on: what it carries, made comparable across interfaces by eta² of the medium it
/// is in, which compresses radiance without any light being lost [Veach 1997, section 5.2].
using Survival = double (*)(const Spectrum& throughput, double eta_squared);
double survive_by_throughput(const Spectrum& throughput, double eta_squared);

/// A path on its way from the sensor: everything that its next step depends on.
struct PathState {
    Ray ray;               ///< towards the next vertex
    Vec3 from, direction;  ///< where the ray was chosen, and its direction before it was rounded
    Spectrum throughput = Spectrum::grey(1);
    double pdf = 0;          ///< of the direction, per steradian; 0 where no emitter sample competes: at the sensor and
                             ///< behind mirrors
    double eta_squared = 1;  ///< of the medium over the sensor's, squared
    std::uint16_t vertex = 1;  ///< the number of the next vertex, which is the edges up to it
};

/// Path tracing: next event estimation and BSDF samples with multiple importance sampling at each vertex
/// [Kajiya 1986; Veach & Guibas 1995].
struct PathTracer final : PathEstimator {
    PathLimits limits;
    NextEvent next_event = default_next_event();
    Survival survival = survive_by_throughput;

    PathTracer() = default;
    explicit PathTracer(const PathLimits& path_limits) : limits(path_limits) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;

    /// One step: the ray is traced, light that it meets and light at the vertex are added to the record, and a new
    /// direction is chosen. Empty where the path ends.
    std::optional<PathState> step(const Scene& scene, const Point<2>& film, const PathState& state,
                                  PrimarySamples& samples, PathRecord& record) const;

private:
    std::optional<PathState> scatter(const PathVertex& vertex, const PathState& state, PrimarySamples& samples,
                                     PathRecord& record) const;
};

}  // namespace plumb
