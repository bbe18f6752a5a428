#include "integrators/paths/vertex.h"

namespace plumb {

namespace {

// The pixel of the region that u falls in, and how far into it u is.
struct Chosen {
    double pixel, rest;
};
Chosen choose(int first, int count, double u) {
    const double place = u * count, below = std::min(std::floor(place), count - 1.0);
    return {first + below, place - below};
}

}  // namespace

CameraStart start_at_camera(const Scene& scene, const FilmRegion& region, Draws& draws) {
    const std::array<double, 2> u = draws.at({0, Use::film});
    const Chosen x = choose(region.x, region.width, u[0]), y = choose(region.y, region.height, u[1]);
    const Point<2> film = sample_film(scene.sensor().filter(), {x.pixel, y.pixel}, {x.rest, y.rest});
    const Point<2> lens = scene.sensor().has_lens() ? Point<2>(draws.at({0, Use::lens})) : Point<2>{0.5, 0.5};
    return {film, scene.sensor().sample_ray(film, lens)};
}

std::optional<Hit> trace_to_hit(const Scene& scene, const Ray& ray, std::uint16_t vertex, Draws& draws,
                                PathRecord& record) {
    const double u = scene.has_masks() ? draws.at({vertex, Use::shadow})[0] : 0;
    return scene.intersect(ray, u, record.rays);
}

std::optional<PathVertex> trace_to_vertex(const Scene& scene, const Ray& ray, std::uint16_t vertex, Draws& draws,
                                          PathRecord& record) {
    const std::optional<Hit> hit = trace_to_hit(scene, ray, vertex, draws, record);
    if (!hit) return {};
    return vertex_at(scene, *hit, ray);
}

PathVertex vertex_at(const Scene& scene, const Hit& hit, const Ray& ray) {
    const Vec3 wo = normalize(-ray.direction);
    return {hit, wo, Frame(hit.shading_normal), scene.bsdf(hit, wo)};
}

std::optional<ScatterSample> sample_bsdf(const PathVertex& vertex, std::uint16_t number, Draws& draws,
                                         Transport transport) {
    const std::array<double, 2> direction = draws.at({number, Use::direction});
    const double lobe = draws.at({number, Use::lobe})[0];
    const auto sample = vertex.bsdf.sample(vertex.to_local(vertex.wo), {lobe, direction[0], direction[1]}, transport);
    if (!sample) return {};
    const Vec3 wi = vertex.frame.to_world(sample->wi);
    if (!vertex.lit(wi, transport)) return {};
    return ScatterSample{wi, sample->weight, sample->pdf, sample->measure, sample->eta};
}

Spectrum eval_bsdf(const PathVertex& vertex, Vec3 wi, Transport transport) {
    if (!vertex.bsdf.smooth() || !vertex.lit(wi, transport)) return {};
    return vertex.bsdf.eval(vertex.to_local(vertex.wo), vertex.to_local(wi), transport);
}

}  // namespace plumb
