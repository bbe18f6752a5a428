#pragma once

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// The beginning of a path at the sensor: its film point, and the ray that enters the scene.
struct CameraStart {
    Point<2> film;
    Ray ray;
};
CameraStart start_at_camera(const Scene& scene, const FilmRegion& region, Draws& draws);

/// The surface that a ray meets first, at the vertex of this number (the sensor is 0); empty where the ray leaves the
/// scene.
std::optional<Hit> trace_to_hit(const Scene& scene, const Ray& ray, SampleIndex index, Draws& draws,
                                PathRecord& record);
/// The vertex at a hit, with what scatters there, for light that leaves against the ray.
PathVertex vertex_at(const Scene& scene, const Hit& hit, const Ray& ray);
std::optional<PathVertex> trace_to_vertex(const Scene& scene, const Ray& ray, std::uint16_t vertex, Draws& draws,
                                          PathRecord& record);

/// A direction that the BSDF of a vertex chose, in the world.
struct ScatterSample {
    Vec3 direction;
    Spectrum weight;
    double pdf;
    Measure measure;
    double eta;
};
/// A direction drawn by the BSDF; empty where nothing scatters, or where the normals disagree about the side of the
/// light.
std::optional<ScatterSample> sample_bsdf(const PathVertex& vertex, SampleIndex index, Draws& draws,
                                         Transport transport);
/// Tells the story, where somebody listens, of a direction and the throughput behind it.
inline void tell_scattering(const PathRecord& record, std::uint16_t number, const ScatterSample& sample,
                            const Spectrum& throughput) {
    if (record.story)
        record.story->scattered({number, sample.direction, sample.pdf, sample.measure, sample.eta, throughput});
}
/// Whether a path goes on, which it does with this probability, in the direction told last.
inline bool survives_roulette(double probability, std::uint16_t number, Draws& draws, const PathRecord& record) {
    const bool survives = draws.at({number, Use::roulette})[0] < probability;
    if (record.story) record.story->played(probability, survives);
    return survives;
}

/// The value f |cos| about the shading normal for light from wi (radiance) or to wi (importance); black where the
/// normals disagree about the side of the light.
Spectrum eval_bsdf(const PathVertex& vertex, Vec3 wi, Transport transport);

}  // namespace plumb
