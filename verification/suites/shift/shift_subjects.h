#pragma once

#include "integrators/estimators/hybrid_shift.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {

// The claims shift/* share what follows: pixels of small scenes to shift between, the numbers that lead `path` along a
// shifted path, and mappings with a defect.

/// Two pixels of a scene.
struct PixelPair {
    const Scene& scene;
    FilmRegion from, to;
};

/// A floor, a wall and a lamp on either side of a curtain that lets half of the light through, the curtain in sight.
const Scene& curtain_scene();
/// A shining wall before a floor, seen in rough metal: most connections end at lights.
const Scene& metal_scene();

/// Pixels of scenes of all kinds of lights and ends of connections.
std::vector<std::pair<std::string, PixelPair>> shift_scenes();

/// Numbers of which some are replaced.
class Replaced final : public PrimarySamples {
public:
    explicit Replaced(PrimarySamples& rest) : rest_(rest) {}
    void set(Slot slot, const std::array<double, 2>& u);
    Drawn at(Slot slot) override;

private:
    PrimarySamples& rest_;
    std::vector<std::pair<Slot, Drawn>> replaced_;
};

/// Numbers by which a vertex scatters in a direction, by its smooth part: the lobe's, and those of the direction. Exact
/// for cosine lobes, to 1e-12 by Newton's method for the rest, which begins at `near` where that is given; empty where
/// there are none, or it does not converge.
using LobeNumbers = std::array<double, 3>;
std::optional<LobeNumbers> numbers_towards(const PathVertex& vertex, Vec3 direction,
                                           const std::optional<LobeNumbers>& near = {});

/// Numbers in place of the base's that lead `path` along a shifted path: of the directions at the connection, and at
/// the vertex behind it, where the path goes on there by a smooth lobe. Empty where the base was not reconnected, or
/// numbers_towards() is.
struct NumbersOfShift {
    std::optional<LobeNumbers> at_connection, beyond;
};
/// By how much both directions are turned, in radians, about two axes across each.
struct Turned {
    Point<2> at_connection{}, beyond{};
};
std::optional<NumbersOfShift> numbers_of_shift(const Scene& scene, const BasePath& base, const ShiftedPath& shifted,
                                               const Turned& turned = {}, const NumbersOfShift& near = {});

/// A shift for a path tracer, so that a claim can put others in its place.
using MakeShift = std::function<std::unique_ptr<PathShift>(const PathTracer& tracer)>;
std::unique_ptr<PathShift> hybrid(const PathTracer& tracer);
/// The hybrid shift with another density in the Jacobian, at the connection or behind it.
MakeShift hybrid_by(ConnectionDensity density, ConnectionDensity beyond = density_beyond);
/// Connects wherever the base does, even where the shifted path would be connected earlier.
std::unique_ptr<PathShift> asymmetric(const PathTracer& tracer);
/// A failed part fails the whole path.
std::unique_ptr<PathShift> valid_by_path(const PathTracer& tracer);

}  // namespace plumb::suites
