#pragma once

#include "integrators/estimators/path.h"
#include "integrators/paths/connection.h"

namespace plumb {

/// The index that a kept direction leads into, over that on the side where the path comes from: at the far end of a
/// connection, which the base may have met from the other side, so that one of the paths is refracted there and the
/// other reflected.
using EtaBeyond = double (*)(const PathStory::Scattering& onwards, const PathVertex& end);
double eta_of_shifted(const PathStory::Scattering& onwards, const PathVertex& end);

/// The shift of `path` that replays numbers up to the first edge (x_k, x_{k+1}) that can be a connection, and then
/// joins y_k to the same x_{k+1}: what lies behind costs no rays [Lin et al. 2022, section 7; Hua et al. 2019].
///
/// Derivation. Let T keep the numbers of the vertices before k and all numbers but those of the directions at k and
/// k + 1, the vertex x_{k+1} (or the direction at x_k, where that leads to the environment), and the direction at
/// x_{k+1}. A direction's three numbers (lobe, u) and the direction ω say the same, once the smooth lobes of a BSDF are
/// not told apart: uniform numbers give ω with the density pdf(ω), and values depend on ω alone. So
///   p(x) dx = … pdf(x_k → x_{k+1}) dω_k · pdf(x_{k+1} → x_{k+2}) dω_{k+1} …,   dω_k = cos/d² dA(x_{k+1}),
/// with cos at x_{k+1} and d the length of the edge. T keeps dA and dω_{k+1}; primary samples have density 1 where x
/// has the density p(x) in these; hence in primary samples
///   J = p(y)/p(x) = pdf(y_k → x_{k+1})/pdf(x_k → x_{k+1}) · cos'/cos · d²/d'² · pdf_y/pdf_x(x_{k+1} → x_{k+2}).
/// The last ratio is only in parts behind x_{k+1}: what is gathered there does not depend on that direction. At the
/// environment cos and d drop out. Behind, vertices see the same directions: densities are equal, and cancel. Lights
/// are chosen at k + 1 and behind by the same numbers from the same places. Roulette's numbers are kept and played
/// against the throughput of y; of masks, the number that decides is kept.
///
/// What keeps T invertible: y must have its first connection at k too (connects_earlier), and be a path: where
/// something stands between y_k and x_{k+1}, y is no dark path but none (occluded), and so it is where nothing scatters
/// that way or roulette ends it. Where x_{k+1} sends the path on by a mirror, the direction cannot be kept: parts
/// behind it fail, the light gathered at x_{k+1} does not. Parts up to k are replayed, with J = 1, and valid where x
/// and y both replay them; there a path that has ended is a dark one.
struct HybridShift final : PathShift {
    const PathTracer& tracer;
    ConnectionFailure failure = connection_failure;
    ConnectionFailure earlier = connection_failure;  ///< of the edges that the shifted path replays
    ConnectionDensity density = connection_density, beyond = density_beyond;
    EtaBeyond eta_beyond = eta_of_shifted;

    explicit HybridShift(const PathTracer& of) : tracer(of) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const override;
    void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
               ShiftedPath& shifted) const override;
};

}  // namespace plumb
