#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "estimators/densities/piecewise_constant.h"
#include "scenes/description/models.h"
#include "scenes/emitters/distant.h"

namespace plumb {

/// Radiance from every direction, looked up in a latitude-longitude picture. In its own frame y is up; row 0 is at the
/// top and a column's longitude is atan2(x, −z), so that the picture's left edge is −z and x lies a quarter to the
/// right, as in Mitsuba. Pixel (i, j) has its centre at ((i + ½)/width, (j + ½)/height); between centres the lookup is
/// bilinear in longitude and latitude, periodic across the left edge, constant beyond the outermost rows.
///
/// The density is constant per steradian on each pixel's cell, and proportional to what the cell holds: the mean
/// luminance there of the bilinear function, times the cell's solid angle Δφ (cos θ_j − cos θ_{j+1}). The mean over a
/// cell of a bilinear function through pixel centres weighs the neighbours 1/8, 6/8, 1/8 along each axis (½∫ of a hat
/// function over each half cell), hence is positive wherever the lookup is: no light is missed. Within the cell
/// longitude and cos θ are drawn uniformly, so no 1/sin θ appears and the density is bounded.
class EnvironmentMap {
public:
    static constexpr LightKind kind = LightKind::environment;

    /// A map with these pixels, row by row; `frame` has the map's axes in the world. Throws Error for a map without
    /// pixels, with one that is not finite or negative, or all black.
    EnvironmentMap(std::size_t width, std::size_t height, std::vector<Spectrum> pixels, const Frame& frame = {});

    [[nodiscard]] std::optional<LightSample> sample(Vec3 from, const Point<2>& u) const;
    [[nodiscard]] std::optional<LightHit> hit(Vec3 from, Vec3 direction) const;
    [[nodiscard]] EmittedRay sample_ray(const Ball& scene, const Point<2>& u, const Point<2>& v) const {
        return send_from_afar(scene, *sample(scene.centre, v), u);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball& scene, Vec3, Vec3 direction) const {
        return ray_pdf_from_afar(scene, hit(scene.centre, -direction)->pdf);
    }
    [[nodiscard]] Spectrum power(double scene_radius) const;

    /// The bilinear lookup at (u, v) in [0,1]²; v grows downwards.
    [[nodiscard]] Spectrum lookup(const Point<2>& uv) const;
    /// The point (u, v) of the picture for a direction in the world.
    [[nodiscard]] Point<2> place_of(Vec3 direction) const;

private:
    struct Cell {
        std::size_t column, row;
    };
    [[nodiscard]] Spectrum pixel(std::ptrdiff_t column, std::ptrdiff_t row) const;
    [[nodiscard]] Spectrum cell_mean(std::size_t column, std::size_t row) const;
    [[nodiscard]] double cos_above(std::size_t row) const;
    [[nodiscard]] double solid_angle(std::size_t row) const;
    [[nodiscard]] double pdf(const Cell& cell) const;

    std::size_t width_, height_;
    std::vector<Spectrum> pixels_;
    Frame frame_;
    std::vector<PiecewiseConstant> columns_;  // of each row
    std::vector<PiecewiseConstant> rows_;     // one
};
static_assert(LightModel<EnvironmentMap>);

namespace description {

/// An environment from a picture in latitude and longitude; v = 0 is the direction +y of its own space.
struct EnvironmentMap {
    std::filesystem::path file;
    double scale = 1;
    Transform to_world;

    static constexpr std::array plugins{
        Plugin{"envmap", "radiance by direction, from a picture in latitude and longitude"}};
    static EnvironmentMap load(Properties& properties);
    /// The light that it becomes: reads the picture. Throws Error where that fails, or to_world is no rotation.
    [[nodiscard]] plumb::EnvironmentMap light() const;
};

}  // namespace description

}  // namespace plumb
