#include "scenes/emitters/lights.h"

namespace plumb {

namespace {

Light at_place(const description::Place& place, const auto& make) {
    try {
        return make();
    } catch (const Error& error) {
        throw place.error(error.what());
    }
}

/// The light that the geometry is, where nothing is its light yet and this kind takes it.
template <class Candidate, class Geometry>
void offer(std::optional<Light>& light, const Geometry& geometry, const Spectrum& radiance) {
    if constexpr (requires { Candidate::of(geometry, radiance); }) {
        if (light) return;
        if (std::optional<Candidate> taken = Candidate::of(geometry, radiance)) light.emplace(*std::move(taken));
    }
}

Light light_of(const auto& geometry, const Spectrum& radiance) {
    std::optional<Light> light;
    for_each_type(AreaLights{},
                  [&]<class Candidate>(std::type_identity<Candidate>) { offer<Candidate>(light, geometry, radiance); });
    if (!light) throw Error("an area emitter on a shape that cannot shine");
    return *std::move(light);
}

}  // namespace

Light area_light(const description::Shape& shape) {
    return at_place(shape.emitter->place, [&] {
        return std::visit([&](const auto& geometry) { return light_of(geometry, shape.emitter->radiance); },
                          shape.geometry);
    });
}

Light shapeless_light(const description::Emitter& emitter) {
    return at_place(emitter.place,
                    [&] { return std::visit([](const auto& kind) { return Light(kind.light()); }, emitter.kind); });
}

double pdf_of_sample(const Light& light, Vec3 from, Vec3 direction, Vec3 position, Vec3 normal) {
    if (is_environment(light)) return std::visit([&](const auto& sky) { return sky.hit(from, direction)->pdf; }, light);
    if (kind_of(light) == LightKind::point) return 1;
    const double cos_at_light = -dot(normal, direction);
    if (!(cos_at_light > 0)) return 0;
    const auto pdf = [&](const auto& model) {
        if constexpr (requires { model.pdf_area(); })
            return per_steradian(model.pdf_area(), length(position - from), cos_at_light);
        else if constexpr (requires { model.pdf(from); })
            return model.pdf(from);
        else
            return 0.0;
    };
    return std::visit(pdf, light);
}

}  // namespace plumb
