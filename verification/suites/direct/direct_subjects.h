#pragma once

#include <functional>
#include <memory>

#include "core/random.h"
#include "integrators/estimators/direct.h"

namespace plumb::suites {

// The claims direct/* share what follows: scenes built from a few shapes, paths through a given film point, and an
// integrator assembled from the library's parts, so that mutants replace one of them.

/// Primary samples in which the film point is given and all other numbers are those of `rest`.
class AtFilmPoint final : public PrimarySamples {
public:
    AtFilmPoint(const Scene& scene, const Point<2>& film, PrimarySamples& rest);
    Drawn at(Slot slot) override { return slot.use == Use::film ? film_ : rest_.at(slot); }
    /// The pixel that the film point lies in, which is the region to trace with these numbers.
    [[nodiscard]] const FilmRegion& pixel() const { return pixel_; }

private:
    FilmRegion pixel_;
    Drawn film_;
    PrimarySamples& rest_;
};

/// The mean of n paths through a film point, or of a whole region where there is none, with Owen-scrambled numbers;
/// contributions of more edges than `edges` are left out.
struct Measurement {
    const Scene& scene;
    const PathEstimator& estimator;
    std::optional<Point<2>> film = {};
    FilmRegion region = {};
    std::uint32_t n = 16;
    int edges = 2;

    [[nodiscard]] Spectrum draw(RandomStream& random) const;
};

/// Direct illumination with a given estimate of reflected light.
struct DirectBy final : PathEstimator {
    ReflectedLight reflected;
    explicit DirectBy(ReflectedLight r) : reflected(std::move(r)) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

/// An estimator with all values of another, multiplied by a factor.
struct Scaled final : PathEstimator {
    std::shared_ptr<const PathEstimator> estimator;
    double factor;
    Scaled(std::shared_ptr<const PathEstimator> e, double f) : estimator(std::move(e)), factor(f) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

/// The choice by power with changed samples, but its own density.
struct ChangedChoice final : LightChoice {
    using Change = void (*)(SceneLightSample& light, const SurfacePoint& from);
    Change change;
    explicit ChangedChoice(Change c) : change(c) {}
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const override;
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const override;
};
NextEvent with_changed_lights(ChangedChoice::Change change);
NextEvent with_weight(MisWeight weight);
/// The weight that lets a technique count in full beside all others.
double in_full(std::span<const double> densities, std::size_t own);

// ---- scenes from a few shapes

description::MaterialId add_material(description::Scene& scene,
                                     decltype(description::Material::kind) kind = description::Diffuse{
                                         Spectrum::grey(1)});

/// Adds a convex polygon, its outside where the corners turn counterclockwise; it shines where it has a radiance.
void add_polygon(description::Scene& scene, const std::vector<Vec3>& corners, description::MaterialId material,
                 std::optional<Spectrum> radiance = {});
void add_shape(description::Scene& scene, decltype(description::Shape::geometry) geometry,
               description::MaterialId material, std::optional<Spectrum> radiance = {});

/// Adds a rectangle around a point, `half` in its smaller half side, on whose edges and diagonal the point does not
/// lie.
void add_receiver(description::Scene& scene, Vec3 point, Vec3 normal, description::MaterialId material,
                  double half = 0.04);

/// A camera that looks from `from` at a point, which it sees at the centre of a film of this size with a box filter.
description::Sensor camera(Vec3 from, Vec3 at, double fov_x = 20, int width = 1, int height = 1);

/// A unit vector at a right angle to n.
Vec3 perpendicular_to(Vec3 n);

}  // namespace plumb::suites
