#include "scenes/scene.h"

namespace plumb {

namespace {

struct Box {
    Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    void add(Vec3 p) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    void add(const Mesh& mesh) {
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) add(mesh.position(i));
    }
    void add(const description::Sphere& s) {
        const Vec3 reach{s.radius, s.radius, s.radius};
        add(s.center - reach);
        add(s.center + reach);
    }
    void add(const description::Disk& d) {
        for (const double x : {-1., 1.})
            for (const double y : {-1., 1.}) add(d.center + d.axis_x * x + d.axis_y * y);
    }
};

std::vector<Spectrum> powers_of(const std::vector<Light>& lights, double scene_radius) {
    std::vector<Spectrum> powers;
    for (const Light& light : lights)
        powers.push_back(std::visit([&](const auto& l) { return l.power(scene_radius); }, light));
    return powers;
}

}  // namespace

double radius_of(const std::vector<description::Shape>& shapes) {
    Box box;
    for (const description::Shape& shape : shapes)
        std::visit([&](const auto& geometry) { box.add(geometry); }, shape.geometry);
    return shapes.empty() ? 1 : length(box.high - box.low) / 2;
}

Scene::Scene(description::Scene description)
    : description_(std::move(description)),
      embree_(description_.shapes),
      materials_(description_),
      sensor_(description_.sensor.value_or(description::Sensor())) {
    std::vector<std::optional<std::size_t>> of_shape(description_.shapes.size());
    for (std::size_t i = 0; i < of_shape.size(); ++i) {
        const description::Shape& shape = description_.shapes[i];
        has_masks_ = has_masks_ || materials_.is_mask(shape.material);
        if (!shape.emitter) continue;
        of_shape[i] = lights_.size();
        lights_.push_back(area_light(shape));
    }
    for (const description::Emitter& emitter : description_.emitters) {
        lights_.push_back(shapeless_light(emitter));
        if (!is_environment(lights_.back())) continue;
        if (environment_) throw emitter.place.error("a second environment; one is accepted");
        environment_ = lights_.size() - 1;
    }
    for (const auto& index : of_shape) light_of_shape_.push_back(index.value_or(lights_.size()));
    if (!lights_.empty()) chooser_ = LightChooser::by_power(powers_of(lights_, radius_of(description_.shapes)));
}

std::optional<Hit> Scene::intersect(const Ray& ray, double u, RayLog& log) const {
    Ray rest = ray;
    for (;;) {
        log.add(rest, false);
        std::optional<Hit> hit = embree_.intersect(rest);
        if (!hit || !has_masks_) return hit;
        const double stops = opacity(*hit);
        if (u < stops) {
            hit->t = length(hit->point.position - ray.origin) / length(ray.direction);
            return hit;
        }
        u = (u - stops) / (1 - stops);
        rest = leave(hit->point, ray.direction);
    }
}

double Scene::transmittance(const SurfacePoint& from, const EmitterSample& sample, RayLog& log) const {
    const auto segment = [&](const SurfacePoint& start) {
        if (sample.surface) return connect(start, *sample.surface);
        if (!std::isfinite(sample.distance)) return leave(start, sample.direction);
        return connect_to_space(start, from.position + sample.direction * sample.distance);
    };
    if (!has_masks_) {
        const Ray ray = segment(from);
        log.add(ray, true);
        return embree_.occluded(ray) ? 0 : 1;
    }
    double passes = 1;
    for (SurfacePoint start = from;;) {
        const Ray ray = segment(start);
        log.add(ray, false);
        const std::optional<Hit> hit = embree_.intersect(ray);
        if (!hit) return passes;
        passes *= 1 - opacity(*hit);
        if (passes == 0) return 0;
        start = hit->point;
    }
}

Bsdf Scene::bsdf(const Hit& hit, Vec3 wo) const {
    return materials_.at(shape(hit).material, hit.uv, dot(hit.shading_normal, wo) > 0);
}

Spectrum Scene::emitted(const Hit& hit, Vec3 wo) const {
    const auto& emitter = shape(hit).emitter;
    return emitter && dot(hit.point.normal, wo) > 0 ? emitter->radiance : Spectrum{};
}

Spectrum Scene::environment(const Ray& ray) const {
    if (!environment_) return {};
    return std::visit([&](const auto& light) { return light.hit(ray.origin, ray.direction)->radiance; },
                      lights_[*environment_]);
}

std::optional<SceneLightSample> Scene::sample_light(Vec3 from, double u, const Point<2>& v) const {
    if (!chooser_) return {};
    const auto [index, pmf] = chooser_->sample(u);
    const auto sample = std::visit([&](const auto& light) { return light.sample(from, v); }, lights_[index]);
    if (!sample) return {};
    return SceneLightSample{*sample, pmf * sample->pdf};
}

double Scene::light_pdf(const Hit& hit, Vec3 from, Vec3 direction) const {
    const std::size_t index = light_of_shape_[hit.shape];
    if (index == lights_.size()) return 0;
    const double cos_at_light = -dot(hit.point.normal, direction);
    if (!(cos_at_light > 0)) return 0;
    const auto pdf = [&](const auto& light) {
        // The triangle that was met is known: no other need be looked at.
        if constexpr (requires { light.pdf_area(); }) {
            return per_steradian(light.pdf_area(), length(hit.point.position - from), cos_at_light);
        } else {
            const auto met = light.hit(from, direction);
            return met ? met->pdf : 0;
        }
    };
    return chooser_->pmf(index) * std::visit(pdf, lights_[index]);
}

double Scene::environment_pdf(Vec3 from, Vec3 direction) const {
    if (!environment_) return 0;
    return chooser_->pmf(*environment_) *
           std::visit([&](const auto& light) { return light.hit(from, direction)->pdf; }, lights_[*environment_]);
}

}  // namespace plumb
