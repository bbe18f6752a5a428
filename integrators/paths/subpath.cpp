#include "integrators/paths/subpath.h"

namespace plumb {

using Kind = SubpathVertex::Kind;

namespace {

SurfacePoint in_space(Vec3 position) {
    return {.position = position, .normal = {}, .inset = position};
}

}  // namespace

Vec3 SubpathVertex::towards(const SubpathVertex& other) const {
    if (other.kind == Kind::environment) return other.position();
    if (kind == Kind::environment) return -position();
    return normalize(other.position() - position());
}

double per_area(double pdf, const SubpathVertex& from, const SubpathVertex& to) {
    if (to.kind == Kind::environment) return pdf;
    const bool faces_all = to.normal() == Vec3{};
    const double cos = faces_all ? 1 : std::abs(dot(to.normal(), from.towards(to)));
    if (from.kind == Kind::environment) return pdf * cos;
    return pdf * cos / length_squared(to.position() - from.position());
}

double density_onwards(const Scene& scene, const SubpathVertex* before, const SubpathVertex& at,
                       const SubpathVertex& next, PerArea per_area) {
    const Vec3 direction = at.towards(next);
    const auto pdf = [&] {
        if (at.kind == Kind::sensor) {
            const FilmSize film = scene.sensor().film();
            return scene.sensor().pdf({at.position(), direction}) / (static_cast<double>(film.width) * film.height);
        }
        if (!before) {
            const EmittedRayPdf ray = scene.light_ray_pdf(*at.light, at.normal(), direction);
            return at.kind == Kind::environment ? ray.area : ray.direction;
        }
        return at.surface->bsdf.pdf(at.surface->to_local(at.towards(*before)), at.surface->to_local(direction));
    };
    return per_area(pdf(), at, next);
}

double density_of_origin(const Scene& scene, const SubpathVertex& light, const SubpathVertex& next) {
    const EmittedRayPdf ray = scene.light_ray_pdf(*light.light, light.normal(), light.towards(next));
    return light.kind == Kind::environment ? ray.direction : ray.area;
}

double density_of_choice(const Scene& scene, const SubpathVertex& light, const SubpathVertex& from, PerArea per_area) {
    const Vec3 direction = from.towards(light);
    if (light.kind == Kind::environment) return scene.environment_pdf(from.position(), direction);
    if (light.kind == Kind::point_light) return scene.light_ray_pdf(*light.light, {}, -direction).area;
    return per_area(scene.light_pdf(*light.light, light.position(), light.normal(), from.position(), direction), from,
                    light);
}

SubpathVertex sensor_vertex(Vec3 position) {
    return {.kind = Kind::sensor, .point = in_space(position), .light = {}, .surface = {}};
}

SubpathVertex light_vertex(const Scene& scene, Vec3 from, const SceneLightSample& sample) {
    const auto& [light, pdf, index] = sample;
    const Kind kind = light.surface                           ? Kind::light
                      : is_environment(scene.lights()[index]) ? Kind::environment
                                                              : Kind::point_light;
    const Vec3 position = kind == Kind::environment ? light.direction : from + light.direction * light.distance;
    return {.kind = kind, .point = light.surface.value_or(in_space(position)), .light = index, .surface = {}};
}

namespace {

// A ray on its way from the last vertex of a subpath.
struct Flight {
    Ray ray;
    Vec3 direction;
    double pdf;           // as density_onwards has it before it is made per area
    Spectrum throughput;  // of radiance, or flux over the ray's own
    double eta_squared = 1;
};

class Walk {
public:
    Walk(const Scene& scene, Transport transport, const SubpathRules& rules, Draws& draws, PathRecord& record,
         Subpath& path)
        : scene_(scene),
          transport_(transport),
          rules_(rules),
          draws_(draws),
          record_(record),
          path_(path),
          first_(transport == Transport::radiance ? 0 : first_light_vertex) {}

    // Until the subpath has so many edges, or ends. `unit` multiplies throughputs.
    void go(std::optional<Flight> flight, const Spectrum& unit) {
        for (int edges = 1; flight && edges < last_vertex; ++edges) {
            if (!arrive(*flight, unit, edges) || !may_grow(edges)) return;
            flight = scatter(*flight, edges);
        }
    }

private:
    [[nodiscard]] std::uint16_t slot(int edges) const { return static_cast<std::uint16_t>(first_ + edges); }
    // A light's subpath needs another edge, to the lens.
    [[nodiscard]] bool may_grow(int edges) const {
        return rules_.limits.allow(transport_ == Transport::radiance ? edges + 1 : edges + 2);
    }

    bool arrive(const Flight& flight, const Spectrum& unit, int edges) {
        const auto hit = trace_to_hit(scene_, flight.ray, slot(edges), draws_, record_);
        SubpathVertex vertex{.kind = Kind::environment,
                             .point = in_space(flight.direction),
                             .light = scene_.environment_light(),
                             .surface = {},
                             .throughput = unit * flight.throughput};
        if (hit) {
            vertex.kind = Kind::surface;
            vertex.point = hit->point;
            vertex.light = scene_.light_of(*hit);
            vertex.surface = vertex_at(scene_, *hit, flight.ray);
            if (transport_ == Transport::radiance)
                record_.meet(*vertex.surface, draws_.density());
            else
                record_.light_vertices.push_back(*vertex.surface);
        } else if (transport_ == Transport::importance || !vertex.light) {
            return false;
        }
        vertex.pdf = rules_.per_area(flight.pdf, path_.back(), vertex);
        vertex.drawn = draws_.density();
        path_.push_back(vertex);
        return hit.has_value();
    }

    std::optional<Flight> scatter(const Flight& flight, int edges) {
        SubpathVertex &at = path_.back(), &before = path_[path_.size() - 2];
        const PathVertex& surface = *at.surface;
        const auto sample = transport_ == Transport::radiance
                                ? sample_bsdf(surface, slot(edges), draws_, rules_.from_camera)
                                : sample_importance(surface, slot(edges), draws_, rules_.correction, rules_.from_light);
        if (!sample) return {};
        at.discrete = sample->measure == Measure::discrete;
        const double back = at.discrete
                                ? sample->pdf
                                : surface.bsdf.pdf(surface.to_local(sample->direction), surface.to_local(surface.wo));
        before.pdf_back = rules_.per_area(back, at, before);
        Flight next{leave(surface.hit.point, sample->direction), sample->direction, sample->pdf,
                    flight.throughput * sample->weight, flight.eta_squared};
        if (transport_ == Transport::radiance) next.eta_squared *= sample->eta * sample->eta;
        tell_scattering(record_, slot(edges), *sample, next.throughput);
        if (is_black(next.throughput)) return {};
        if (edges + 1 <= rules_.limits.roulette_edges) return next;
        const double survives = rules_.survival(next.throughput, next.eta_squared);
        if (!survives_roulette(survives, slot(edges), draws_, record_)) return {};
        next.throughput = next.throughput / survives;
        return next;
    }

    const Scene& scene_;
    Transport transport_;
    const SubpathRules& rules_;
    Draws& draws_;
    PathRecord& record_;
    Subpath& path_;
    int first_;
};

}  // namespace

Subpath camera_subpath(const Scene& scene, const CameraStart& start, const SubpathRules& rules, Draws& draws,
                       PathRecord& record) {
    Subpath path{sensor_vertex(start.ray.origin)};
    const Vec3 direction = normalize(start.ray.direction);
    const FilmSize film = scene.sensor().film();
    const double pdf =
        scene.sensor().pdf({start.ray.origin, direction}) / (static_cast<double>(film.width) * film.height);
    const Flight flight{start.ray, direction, pdf, Spectrum::grey(1)};
    Walk(scene, Transport::radiance, rules, draws, record, path).go(flight, Spectrum::grey(1));
    return path;
}

Subpath light_subpath(const Scene& scene, const SubpathRules& rules, Draws& draws, PathRecord& record) {
    const auto start = start_at_light(scene, draws, record);
    if (!start) return {};
    const auto& [ray, light, chance] = start->light;
    const bool environment = is_environment(scene.lights()[light]);
    SubpathVertex first{.kind = ray.surface   ? Kind::light
                                : environment ? Kind::environment
                                              : Kind::point_light,
                        .point = ray.surface.value_or(in_space(environment ? -ray.direction : ray.origin)),
                        .light = light,
                        .surface = {}};
    const double area = ray.pdf.area * chance;
    first.pdf = environment ? ray.pdf.direction : area;
    first.drawn = start->origin_density;
    // What it emits per steradian and cosine, over its density per area: flux without the choice of a direction.
    if (ray.surface) first.throughput = ray.weight * (ray.pdf.direction / dot(ray.surface->normal, ray.direction));
    Subpath path{first};
    if (!rules.limits.allow(2)) return path;
    const Flight flight{start->ray, ray.direction, environment ? area : ray.pdf.direction, Spectrum::grey(1)};
    Walk(scene, Transport::importance, rules, draws, record, path).go(flight, ray.weight);
    return path;
}

}  // namespace plumb
