#include "integrators/estimators/bdpt.h"

namespace plumb {

using Kind = SubpathVertex::Kind;

namespace {

// The connections of two subpaths.
class Connections {
public:
    Connections(const Bdpt& bdpt, const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
                PathRecord& record)
        : bdpt_(bdpt), scene_(scene), samples_(samples), record_(record) {
        Draws from_camera(samples), from_light(samples);
        start_ = start_at_camera(scene, region, from_camera);
        camera_ = camera_subpath(scene, start_, bdpt.rules, from_camera, record);
        light_ = light_subpath(scene, bdpt.rules, from_light, record);
    }

    void make_all() {
        for (std::size_t t = 2; t <= camera_.size(); ++t) {
            meet_light(t);
            if (!may_connect(camera_[t - 1])) continue;
            if (allowed(t)) sample_light(t);
            for (std::size_t s = 2; s <= light_.size() && allowed(s + t - 1); ++s) connect(s, t);
        }
        for (std::size_t s = 1; s <= light_.size() && allowed(s); ++s) connect_to_lens(s);
    }

private:
    [[nodiscard]] bool allowed(std::size_t edges) const { return bdpt_.rules.limits.allow(static_cast<int>(edges)); }
    static bool may_connect(const SubpathVertex& vertex) { return vertex.surface && vertex.surface->bsdf.smooth(); }

    [[nodiscard]] double weight_of(std::span<const SubpathVertex> camera, std::span<const SubpathVertex> light) {
        join(scene_, *bdpt_.choice, camera, light, bdpt_.rules.per_area, chain_);
        return bdpt_.weight(chain_, static_cast<int>(camera.size()));
    }
    [[nodiscard]] std::span<const SubpathVertex> camera(std::size_t t) const { return {camera_.data(), t}; }
    [[nodiscard]] std::span<const SubpathVertex> light(std::size_t s) const { return {light_.data(), s}; }

    // `density`: of the numbers of both subpaths up to s and t, and of the connection.
    void add(const Point<2>& film, const Spectrum& value, std::size_t s, std::size_t t, double weight, double density,
             std::optional<std::size_t> source = {}) {
        const Strategy strategy{static_cast<int>(s), static_cast<int>(t)};
        if (record_.story)
            record_.tell({.strategy = strategy,
                          .light = value / weight,
                          .weight = weight,
                          .source = source,
                          .density = density});
        if (!is_black(value)) record_.add({film, value, strategy.edges(), t == 1}, density);
    }

    // (0, t)
    void meet_light(std::size_t t) {
        const SubpathVertex& last = camera_[t - 1];
        if (!last.light) return;
        const Ray ray{camera_[t - 2].position(), last.position()};
        const Spectrum radiance =
            last.surface ? scene_.emitted(last.surface->hit, last.surface->wo) : scene_.environment(ray);
        if (is_black(radiance)) return;
        const double weight = weight_of(camera(t), {});
        if (weight == 0) return;
        add(start_.film, last.throughput * radiance * weight, 0, t, weight, last.drawn, last.light);
    }

    // (1, t)
    void sample_light(std::size_t t) {
        const SubpathVertex& last = camera_[t - 1];
        const SampleIndex index{static_cast<std::uint16_t>(t - 1)};
        Draws draws(samples_);
        const auto sampled = bdpt_.choice->sample(scene_, last.point, index, draws);
        if (!sampled) return;
        const LightSample& sample = sampled->sample;
        const Spectrum f = eval_bsdf(*last.surface, sample.direction, Transport::radiance);
        if (is_black(f)) return;
        SubpathVertex end = light_vertex(scene_, last.position(), *sampled);
        end.pdf = density_of_origin(scene_, end, last);
        const double weight = weight_of(camera(t), {&end, 1});
        if (weight == 0) return;
        const double arrives = bdpt_.visibility->sample(scene_, last.point, sample, index, draws, record_.rays);
        add(start_.film, last.throughput * f * sample.radiance * (weight * arrives / sampled->pdf), 1, t, weight,
            last.drawn * draws.density(), sampled->light);
    }

    // (s, t), s and t ≥ 2
    void connect(std::size_t s, std::size_t t) {
        const SubpathVertex &x = camera_[t - 1], &y = light_[s - 1];
        if (!may_connect(y)) return;
        const Vec3 way = y.position() - x.position();
        const double distance = length(way);
        if (!(distance > 0)) return;
        const Vec3 direction = way / distance;
        const Spectrum f_x = eval_bsdf(*x.surface, direction, Transport::radiance);
        if (is_black(f_x)) return;
        const Spectrum f_y = eval_bsdf(*y.surface, -direction, Transport::importance);
        if (is_black(f_y)) return;
        const double weight = weight_of(camera(t), light(s));
        if (weight == 0) return;
        const LightSample end{direction, distance, {}, 0, Measure::solid_angle, y.point};
        const SampleIndex index{static_cast<std::uint16_t>(t - 1), static_cast<std::uint8_t>(s - 1)};
        Draws draws(samples_);
        const double arrives = bdpt_.visibility->sample(scene_, x.point, end, index, draws, record_.rays);
        const double scale =
            weight * arrives * bdpt_.rules.correction(*y.surface, -direction) * bdpt_.rules.falloff(x, y);
        add(start_.film, x.throughput * f_x * f_y * y.throughput * scale, s, t, weight,
            x.drawn * y.drawn * draws.density());
    }

    // (s, 1)
    void connect_to_lens(std::size_t s) {
        const SubpathVertex& y = light_[s - 1];
        if (s == 1 ? y.kind != Kind::light : !may_connect(y)) return;
        const auto number = static_cast<std::uint16_t>(first_light_vertex + s - 1);
        Draws draws(samples_);
        const auto lens = sample_lens(scene_, y.position(), number, draws, bdpt_.connection);
        if (!lens) return;
        const double cos_at_light = dot(y.normal(), lens->direction);
        const Spectrum f = s > 1 ? eval_bsdf(*y.surface, lens->direction, Transport::importance) *
                                       bdpt_.rules.correction(*y.surface, lens->direction)
                                 : Spectrum::grey(std::max(0.0, cos_at_light));
        if (is_black(f)) return;
        const SubpathVertex sensor = sensor_vertex(y.position() + lens->direction * lens->distance);
        const double weight = weight_of({&sensor, 1}, light(s));
        if (weight == 0) return;
        const double arrives =
            bdpt_.visibility->sample(scene_, y.point, end_at_lens(*lens), {number}, draws, record_.rays);
        add(lens->film, y.throughput * f * (weight * arrives * lens->importance / lens->pdf), s, 1, weight,
            y.drawn * draws.density());
    }

    const Bdpt& bdpt_;
    const Scene& scene_;
    CameraStart start_;
    PrimarySamples& samples_;
    PathRecord& record_;
    Subpath camera_, light_;
    PathChain chain_;
};

}  // namespace

Bdpt::Bdpt(const PathLimits& limits) {
    rules.limits = limits;
    if (limits.strategy) weight = strategy_alone(*limits.strategy);
}

void Bdpt::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    record.clear();
    Connections(*this, scene, region, samples, record).make_all();
}

StrategyWeight strategy_alone(const Strategy& strategy) {
    return [strategy](const PathChain& chain, int t) {
        return t == strategy.t && chain.edges() + 1 - t == strategy.s ? 1.0 : 0.0;
    };
}

}  // namespace plumb
