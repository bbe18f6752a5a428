#include "scenes/scene.h"

#include <fmt/format.h>

#include "core/error.h"
#include "scenes/geometry/wide_triangles.h"

namespace plumb {

namespace {

std::vector<Spectrum> powers_of(const std::vector<Light>& lights, double scene_radius) {
    std::vector<Spectrum> powers;
    for (const Light& light : lights)
        powers.push_back(std::visit([&](const auto& l) { return l.power(scene_radius); }, light));
    return powers;
}

description::Scene with_wide_triangles_in_doubles(description::Scene description) {
    meet_wide_triangles_in_doubles(description.shapes);
    return description;
}

// Embree multiplies three lengths in floats: within these, products neither overflow nor vanish.
Ball within_range(const Ball& ball) {
    constexpr double smallest = 0x1p-36, largest = 0x1p40;
    const double reach = length(ball.centre) + ball.radius;
    if (ball.radius >= smallest && reach <= largest) return ball;
    throw Error(
        fmt::format("the scene's shapes fill a ball of radius {:.3g} and reach {:.3g} from the origin; rays in "
                    "single precision accept radii from {:.2g} and distances to {:.2g}: scale the scene",
                    ball.radius, reach, smallest, largest));
}

}  // namespace

Scene::Scene(description::Scene description, MakeChooser choose)
    : description_(with_wide_triangles_in_doubles(std::move(description))),
      ball_(within_range(ball_around(description_.shapes))),
      embree_(description_.shapes),
      materials_(description_.materials, description_.textures),
      sensor_(description_.sensor.value_or(description::Sensor())) {
    std::vector<std::optional<std::size_t>> of_shape(description_.shapes.size());
    for (std::size_t i = 0; i < of_shape.size(); ++i) {
        const description::Shape& shape = description_.shapes[i];
        const bool masked = materials_.is_mask(shape.material);
        has_masks_ = has_masks_ || masked;
        if (!shape.emitter) continue;
        of_shape[i] = lights_.size();
        lights_.push_back(area_light(shape, masked));
        shape_of_light_.push_back(i);
    }
    for (const description::Emitter& emitter : description_.emitters) {
        lights_.push_back(shapeless_light(emitter));
        if (!is_environment(lights_.back())) continue;
        if (environment_) throw emitter.place.error("a second environment; one is accepted");
        environment_ = lights_.size() - 1;
    }
    for (const auto& index : of_shape) light_of_shape_.push_back(index.value_or(lights_.size()));
    if (!lights_.empty()) chooser_ = choose(powers_of(lights_, ball_.radius));
}

std::optional<Hit> Scene::intersect(const Ray& ray, double u, RayLog& log) const {
    if (!has_masks_) {
        log.add(ray, false);
        return embree_.intersect(ray);
    }
    Ray rest = ray;
    for (;;) {
        log.add(rest, false);
        std::optional<Hit> hit = embree_.intersect(rest);
        if (!hit) return hit;
        const double stops = opacity(*hit);
        if (u < stops) {
            hit->t = length(hit->point.position - ray.origin) / length(ray.direction);
            return hit;
        }
        u = (u - stops) / (1 - stops);
        rest = leave(hit->point, ray.direction);
    }
}

double Scene::transmittance(const SurfacePoint& from, const LightSample& sample, RayLog& log) const {
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
    const auto sample = sample_of_light(index, from, v);
    if (!sample) return {};
    return SceneLightSample{*sample, pmf * sample->pdf, index};
}

std::optional<LightSample> Scene::sample_of_light(std::size_t light, Vec3 from, const Point<2>& v) const {
    auto sample = std::visit([&](const auto& one) { return one.sample(from, v); }, lights_[light]);
    if (has_masks_ && sample) sample->radiance = sample->radiance * opacity_of_light(light, v, sample->surface);
    return sample;
}

double Scene::opacity_of_light(std::size_t light, const Point<2>& u, const std::optional<SurfacePoint>& at) const {
    if (!at) return 1;
    const description::Shape& shape = description_.shapes[shape_of_light_[light]];
    if (!materials_.is_mask(shape.material)) return 1;
    return materials_.opacity(shape.material, uv_on_light(shape, lights_[light], u, at->position));
}

double Scene::light_pdf(const Hit& hit, Vec3 from, Vec3 direction) const {
    const auto light = light_of(hit);
    return light ? light_pdf(*light, hit.point.position, hit.point.normal, from, direction) : 0;
}

double Scene::light_pdf(std::size_t light, Vec3 position, Vec3 normal, Vec3 from, Vec3 direction) const {
    return chooser_->pmf(light) * pdf_of_sample(lights_[light], from, direction, position, normal);
}

std::optional<std::size_t> Scene::light_of(const Hit& hit) const {
    const std::size_t light = light_of_shape_[hit.shape];
    return light == lights_.size() ? std::nullopt : std::optional(light);
}

double Scene::environment_pdf(Vec3 from, Vec3 direction) const {
    if (!environment_) return 0;
    return chooser_->pmf(*environment_) *
           std::visit([&](const auto& light) { return light.hit(from, direction)->pdf; }, lights_[*environment_]);
}

double Scene::least_light_chance() const {
    double least = 1;
    for (std::size_t i = 0; i < lights_.size(); ++i)
        if (const double chance = chooser_->pmf(i); chance > 0) least = std::min(least, chance);
    return least;
}

double Scene::scale_of_light() const {
    double power = 0;
    for (const Spectrum& of_light : powers_of(lights_, ball_.radius)) power += luminance(of_light);
    return power / luminance(ConstantEnvironment{Spectrum::grey(1)}.power(ball_.radius));
}

std::optional<SceneLightRay> Scene::sample_light_ray(double u, const Point<2>& origin,
                                                     const Point<2>& direction) const {
    if (!chooser_) return {};
    const auto [index, chance] = chooser_->sample(u);
    EmittedRay ray =
        std::visit([&](const auto& light) { return light.sample_ray(ball_, origin, direction); }, lights_[index]);
    ray.weight = ray.weight / chance;
    if (has_masks_) ray.weight = ray.weight * opacity_of_light(index, origin, ray.surface);
    return SceneLightRay{ray, index, chance};
}

EmittedRayPdf Scene::light_ray_pdf(std::size_t light, Vec3 normal, Vec3 direction) const {
    EmittedRayPdf pdf =
        std::visit([&](const auto& light) { return light.ray_pdf(ball_, normal, direction); }, lights_[light]);
    pdf.area *= chooser_->pmf(light);
    return pdf;
}

}  // namespace plumb
