#pragma once

#include "integrators/estimators/bdpt.h"
#include "integrators/estimators/light_tracer.h"
#include "integrators/references/path_classes.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {

// The claims of light and bidirectional tracing share what follows: small scenes, and the mean of a film region.

/// The mean luminance of a region by n paths with Owen-scrambled numbers, of paths of one length, or of all but those
/// of one edge: every integrator finds alike what is seen directly.
struct RegionMean {
    const Scene& scene;
    const PathEstimator& estimator;
    FilmRegion region;
    std::uint32_t n = 16;
    int length = 0;

    [[nodiscard]] double draw(RandomStream& random) const;
};
FilmRegion whole_film(const Scene& scene);
/// Whether both, of one scene and n, have one expectation: by differences of draws from the same numbers.
Verdict same_mean(const RegionMean& one, const RegionMean& other, const MeanClaim& claim, const Run& run);

/// By how far across itself a ray from x towards y, or from y towards x, may miss the line between the two: it starts
/// off its surface, and its direction and the point that it meets are rounded (scenes/geometry/surface_point.h:
/// `margin` bounds the rounding within the plane of a triangle).
double ray_miss(const SurfacePoint& x, const SurfacePoint& y);
/// The same over the distance, of rays that only have a direction.
constexpr double ray_turn = 0x1p-21;

/// Relative deviations of which each is held to a bound of its own. Those that may be off by more than 1 % say little:
/// they are counted, and not judged.
class HeldCases {
public:
    void add(const std::string& name, double error, double bound);
    /// Of the largest deviation over its bound.
    [[nodiscard]] Verdict verdict() const;

private:
    std::vector<BoundedCase> cases_;
    std::uint64_t left_out_ = 0;
};

/// Wrong weights: by the density of the next vertex in place of the connected one's, and with connections to mirrors
/// that count as if they could be made.
double weight_of_wrong_vertex(const PathChain& chain, int t);
double weight_with_mirrors_connected(const PathChain& chain, int t);

/// The inside of a diffuse sphere of radius 2 and albedo ½ that emits ½, or is lit by a point of intensity 4π at its
/// centre: paths of k edges bring 2^-k, or 2^(1-k) without those of one edge. The camera is off the centre.
const Scene& glowing_sphere();
const Scene& sphere_around_point();

/// A diffuse room lit by a rectangle: walls that touch, and a block. It is seen through a lens, with pixels by a
/// Gaussian that reaches beyond the film.
const Scene& box_scene();
/// Rough metal, rough glass, a rough coat and a floor, under a constant sky, with a point light.
const Scene& rough_scene();
/// A floor lit by a sphere light within a ball of glass and by mirrors, all out of the camera's sight.
const Scene& caustic_scene();
/// An octahedron with normals that lean towards a rectangle, which lights it, and nothing else.
const Scene& smooth_normals_scene();
/// Three plates that do not touch, one of which shines.
const Scene& plates_scene();
/// A coated floor, a wall and a shelf under a large dim lamp, a small bright one and a dim sky.
const Scene& lamps_scene();
/// Two balls of glass on a floor before a wall, lit by a surface, a point or the sky.
const Scene& glass_scene(PathClass::Source source);

}  // namespace plumb::suites
