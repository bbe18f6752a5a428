// A patch under a disk sees a sky that is known.

#include "integrators/estimators/ambient.h"
#include "integrators/paths/vertex.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

/// Reflectance 1/2, facing a disk of radius 1 at height 1, which hides r²/(r² + h²) = 1/2 of the cosine-weighted sky.
const Scene& patch_under_disk() {
    static const Scene scene([] {
        description::Scene under;
        const auto grey = add_material(under, description::Diffuse{Spectrum::grey(0.5)});
        add_receiver(under, {}, {0, 0, 1}, grey);
        add_shape(under, description::Disk{.center = {0, 0, 1}}, grey);
        under.sensor = camera({0, 0, 0.1}, {});
        return under;
    }());
    return scene;
}

/// Nothing hides the sky.
struct Unhidden final : PathEstimator {
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        record.clear();
        Draws draws(samples);
        const CameraStart start = start_at_camera(scene, region, draws);
        const auto vertex = trace_to_vertex(scene, start.ray, 1, draws, record);
        if (!vertex) return;
        const auto scattered = sample_bsdf(record.meet(*vertex, 1), {1}, draws, Transport::radiance);
        if (scattered) record.add({start.film, scattered->weight, 2}, draws.density());
    }
};

using Subject = std::shared_ptr<const PathEstimator>;

Verdict sees_half(const Subject& estimator, const Run& run) {
    const Measurement measurement{patch_under_disk(), *estimator, Point<2>{0.5, 0.5}};
    return mean_is(
        [&](RandomStream& random) { return luminance(measurement.draw(random)); },
        {.reference = 0.25, .delta = 0.0025, .epsilon = 1e-6, .bounds = {0, 0.52}, .cap = std::uint64_t{1} << 17}, run);
}

}  // namespace

void add_transport_ambient(Catalogue& catalogue) {
    const auto ambient = std::make_shared<Ambient>();
    catalogue.add({.id = "render/ambient/disk",
                   .statement = "Under a disk that hides half of its sky, a grey patch has half of its reflectance.",
                   .source = "ours, integrators/estimators/ambient.h",
                   .kind = Kind::mean,
                   .trial = {sees_half,
                             ambient,
                             {{"unhidden", "what hides the sky is left out", std::make_shared<Unhidden>()},
                              {"bright", "the sky is 3 % too bright", std::make_shared<Scaled>(ambient, 1.03)}}}});
}

}  // namespace plumb::suites
