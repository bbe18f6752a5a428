#pragma once

#include <variant>

#include "scenes/geometry/surface_point.h"
#include "scenes/sensors/all.h"

namespace plumb {

/// The camera, film and filter that a description asks for.
class SceneSensor {
public:
    using Model = description::OneOf<Sensors>;

    /// The sensor of a description. Throws Error naming file and line.
    explicit SceneSensor(const description::Sensor& sensor);

    [[nodiscard]] FilmSize film() const { return film_; }
    [[nodiscard]] const Filter& filter() const { return filter_; }
    [[nodiscard]] bool has_lens() const {
        return std::visit([](const auto& m) { return m.has_lens; }, model_);
    }

    [[nodiscard]] Ray sample_ray(const Point<2>& film, const Point<2>& lens) const {
        const Ray ray = std::visit([&](const auto& m) { return m.sample_ray(film, lens); }, model_);
        return rounded_ray(ray.origin, ray.direction);
    }
    /// The density per steradian of a ray whose direction is a unit vector, for film points beyond the film too, where
    /// a filter reaches.
    [[nodiscard]] double pdf(const Ray& ray) const {
        return std::visit([&](const auto& m) { return m.pdf(ray); }, model_);
    }
    /// The connection from a point to the lens, for film points beyond the film too, where a filter reaches.
    [[nodiscard]] std::optional<SensorSample> connect(Vec3 from, const Point<2>& lens) const {
        return std::visit([&](const auto& m) { return m.connect(from, lens); }, model_);
    }

private:
    FilmSize film_;
    Filter filter_;
    Model model_;
};

}  // namespace plumb
