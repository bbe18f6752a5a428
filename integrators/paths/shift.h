#pragma once

#include <array>
#include <string>

#include "integrators/paths/path_estimator.h"

namespace plumb {

// A shift mapping takes a path x of one pixel to a path y = T(x) of another, so that what was found at the one can be
// used at the other: with primary samples of density 1 on either side,
//   ∫ f(y) dy over the image of T  =  ∫ f(T(x)) J(x) dx over where T is valid,   J = |∂T/∂x|,
// f being a splat's value (the contribution over its density). T from i to j and T from j to i are inverse to each
// other where both are valid, and each is valid where the other is: a path that is not the image of its own shift back
// must be a failure, or light is counted twice, or never.
//
// J and validity are those of a *part* of a path: the light gathered at one vertex (a light that the path met there,
// and what next-event estimation found from there). A part depends on the numbers up to its vertex alone, so that a
// path whose tail cannot be shifted still brings its head.

/// Why a part of a path has no counterpart at another pixel.
enum class ShiftFailure : std::uint8_t {
    none,
    connects_earlier,  ///< the shifted path would be reconnected before, so that its shift back is another path
    ended,             ///< the replay ended before the connection
    too_smooth,        ///< one of the vertices to connect
    too_near,          ///< the vertices to connect, to each other
    occluded,          ///< so are they
    no_density,        ///< nothing scatters that way, or carries anything
    mirror,            ///< at the far end of the connection: what comes behind it needs its very direction
    roulette,          ///< would have ended the shifted path
};
constexpr std::size_t shift_failures = 9;
std::string to_string(ShiftFailure failure);

/// The outcome of the shift of a part.
struct ShiftedPart {
    double jacobian = 1;  ///< |∂T/∂x| of primary samples; nothing where it failed
    ShiftFailure failure = ShiftFailure::none;

    [[nodiscard]] bool valid() const { return failure == ShiftFailure::none; }
};

/// A splat of a part: 0 is gathered at the first vertex, where the sensor's ray ends.
struct PartSplat {
    Splat splat;
    std::size_t part;
};
Spectrum light_of_part(const std::vector<PartSplat>& splats, std::size_t part);

/// A path that can be shifted. Reused from path to path.
struct BasePath {
    PathRecord record;
    PathStory story;
    std::vector<PartSplat> splats;
    std::size_t parts = 0;       ///< that the path has, dark ones too
    std::size_t connection = 0;  ///< vertex from which it is reconnected, the first being 1; 0: it is replayed whole
};

/// The path at the other pixel. Parts that the base has not, dark there, may be found here.
struct ShiftedPath {
    std::vector<ShiftedPart> parts;
    std::vector<PartSplat> splats;  ///< of valid parts
    PathRecord record;              ///< of what was replayed; its rays count on

    void clear() {
        parts.clear();
        splats.clear();
    }
};

/// What became of the parts shifted in a render, by reason.
struct ShiftCounts {
    std::array<std::uint64_t, shift_failures> parts{};

    void add(const ShiftedPath& shifted) {
        for (const ShiftedPart& part : shifted.parts) ++parts[static_cast<std::size_t>(part.failure)];
    }
    ShiftCounts& operator+=(const ShiftCounts& other);
    [[nodiscard]] std::uint64_t total() const;
    /// `83.1 % of 5120 parts shifted, 9.2 % occluded, …`.
    [[nodiscard]] std::string describe() const;
};

/// A shift mapping. The numbers are asked for again and again, and must stay the same from trace() on; they are not
/// guided: all of density 1.
struct PathShift {
    virtual ~PathShift() = default;
    /// A path for the region, bit by bit what its estimator traces.
    virtual void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const = 0;
    /// The base path of the same numbers at another region.
    virtual void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
                       ShiftedPath& shifted) const = 0;
};

/// The same numbers at the other pixel, for any estimator: the identity in primary sample space, hence J = 1, and
/// valid everywhere. A path is one part. The oracle of all other shifts.
struct RandomReplay final : PathShift {
    const PathEstimator& estimator;

    explicit RandomReplay(const PathEstimator& of) : estimator(of) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const override;
    void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
               ShiftedPath& shifted) const override;
};

}  // namespace plumb
