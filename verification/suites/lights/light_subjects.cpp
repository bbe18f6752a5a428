#include "verification/suites/lights/light_subjects.h"

#include <boost/math/quadrature/gauss.hpp>

#include "scenes/emitters/constant_environment.h"
#include "scenes/emitters/disk_light.h"
#include "scenes/emitters/mesh_light.h"
#include "scenes/emitters/point_light.h"
#include "scenes/emitters/rectangle_light.h"
#include "scenes/emitters/sphere_light.h"

namespace plumb::suites {

namespace {

const Spectrum radiance = Spectrum::rgb(1, 2, 3);

template <class E>
Light light_of(std::string name, std::string title, const E& model) {
    Light light;
    light.name = std::move(name);
    light.title = std::move(title);
    light.source = "ours, scenes/emitters";
    light.sample = [model](Vec3 from, const Point<2>& u) { return model.sample(from, u); };
    light.hit = [model](Vec3 from, Vec3 direction) { return model.hit(from, direction); };
    light.power = [model](double scene_radius) { return model.power(scene_radius); };
    light.sample_ray = [model](const Ball& scene, const Point<2>& u, const Point<2>& v) {
        return model.sample_ray(scene, u, v);
    };
    light.ray_pdf = [model](const Ball& scene, Vec3 normal, Vec3 direction) {
        return model.ray_pdf(scene, normal, direction);
    };
    return light;
}

/// A planar light of radiance 2 overhead that shines down from height h, corner or rim at most `reach` from the axis.
/// Its largest density is d³/(h A) at the far end; over a sphere of radius R around it that passes no nearer than
/// R − reach, area · L cos θ cos' A/d² ≤ 4πR² · 2A/(R − reach)².
Light planar(Light light, double area, double h, double reach) {
    light.largest_pdf = std::pow(h * h + reach * reach, 1.5) / (h * area);
    light.reference_power = 2 * pi * area;
    light.centre = {0, 0, h};
    light.enclosing = 4 * reach;
    light.largest_flux = 4 * pi * 16 * 2 * area / 9;
    return light;
}

Light rectangle() {
    Light light = planar(
        light_of("rectangle", "a rectangle light", RectangleLight({-1.5, -1, 1}, {0, 2, 0}, {3, 0, 0}, radiance)), 6, 1,
        std::hypot(1.5, 1));
    light.pdf_defect = "The cosine at the light is missing.";
    light.wrong_pdf = [](Vec3, Vec3, double distance, double) { return distance * distance / 6; };
    return light;
}

Light disk() {
    Light light =
        planar(light_of("disk", "a disk light", DiskLight({0, 0, 1}, {0, 0, -1}, 1.5, radiance)), pi * 2.25, 1, 1.5);
    light.pdf_defect = "The density per area is used per steradian.";
    light.wrong_pdf = [](Vec3, Vec3, double, double) { return 1 / (pi * 2.25); };
    return light;
}

Light mesh() {
    // The kite (0,2), (−1,0), (0,−1), (1,0) in triangles of areas 0.2, 0.8, ½, ½ and 1.
    const Vec3 top{0, 2, 1}, left{-1, 0, 1}, bottom{0, -1, 1}, right{1, 0, 1}, centre{0, 0, 1}, cut{-0.2, 1.6, 1};
    Light light = planar(light_of("mesh", "a mesh light",
                                  MeshLight({{top, centre, cut},
                                             {cut, centre, left},
                                             {left, centre, bottom},
                                             {bottom, centre, right},
                                             {right, centre, top}},
                                            radiance)),
                         3, 1, 2);
    light.pdf_defect = "The probability of a triangle, one in five, is left out.";
    light.wrong_pdf = [](Vec3, Vec3, double, double pdf) { return pdf * 5; };
    return light;
}

/// d = 2, R = 1.2: the cone's 1 − cos is 1 − 0.8. Through a sphere of radius 3 around it: cos ≤ 1, solid angle that of
/// half angle asin(0.4).
Light sphere() {
    Light light = light_of("sphere", "a sphere light seen from outside", SphereLight({0, 1.2, 1.6}, 1.2, radiance));
    light.largest_pdf = 1 / (2 * pi * 0.2);
    light.reference_power = 2 * pi * 4 * pi * 1.44;
    light.centre = {0, 1.2, 1.6};
    light.enclosing = 3;
    light.largest_flux = 4 * pi * 9 * 2 * 2 * pi * (1 - std::sqrt(1 - 0.16));
    light.pdf_defect = "The density of points on the whole sphere, as if its far side were seen too.";
    light.wrong_pdf = [](Vec3 from, Vec3 direction, double distance, double) {
        const Vec3 normal = (from + direction * distance - Vec3{0, 1.2, 1.6}) / 1.2;
        return per_steradian(1 / (4 * pi * 1.44), distance, -dot(normal, direction));
    };
    return light;
}

/// Seen from inside; its flux is taken through a sphere of the same centre within it, where all of 4π steradians shine.
Light inward_sphere() {
    Light light = light_of("sphere-inside", "a sphere light seen from inside",
                           SphereLight({0.3, 0.2, -0.4}, 2, radiance, SphereLight::Side::inwards));
    light.largest_pdf = 1 / (4 * pi);
    light.infinite = light.uniform = true;
    light.centre = {0.3, 0.2, -0.4};
    light.enclosing = 2 * (1 - 1e-12);
    light.reference_power = 2 * pi * 4 * pi * 4;
    light.largest_flux = 4 * pi * 4 * 2 * 4 * pi;
    light.pdf_defect = "The density of half the directions.";
    light.wrong_pdf = [](Vec3, Vec3, double, double) { return 1 / (2 * pi); };
    return light;
}

Light constant() {
    Light light = light_of("constant", "a constant environment", ConstantEnvironment{radiance});
    light.largest_pdf = 1 / (4 * pi);
    light.infinite = light.uniform = true;
    light.enclosing = 3;
    light.reference_power = 2 * 4 * pi * pi * 9;
    light.largest_flux = 4 * pi * 9 * 2 * 4 * pi;
    light.pdf_defect = "The density of half the directions.";
    light.wrong_pdf = [](Vec3, Vec3, double, double) { return 1 / (2 * pi); };
    return light;
}

/// Luminances from 0.5 to 6 in grey: a cell's mean luminance is at least 0.5 and the lookup at most 6, the whole sphere
/// holds at most 4π · 6; so pdf = mean/total lies within [0.5/(24π), 6/(2π)] and L/pdf ≤ 6 · 24π/0.5.
std::vector<Spectrum> environment_pixels() {
    std::vector<Spectrum> pixels;
    for (int i = 0; i < 32; ++i) pixels.push_back(Spectrum::grey(0.5 + 0.5 * ((i * 7 + i / 8) % 12)));
    return pixels;
}

Light environment() {
    Light light = light_of("environment-map", "an environment map", environment_map());
    light.largest_pdf = 6 / (2 * pi);
    light.infinite = true;
    light.enclosing = 1;
    // ∫ L dω: along a row the mean is that of the pixel centres; between rows' centres the lookup is smooth.
    for (int half = 0; half < 8; ++half)
        light.reference_power += pi * boost::math::quadrature::gauss<double, 15>::integrate(
                                          [](double theta) {
                                              double sum = 0;
                                              for (int i = 0; i < 8; ++i)
                                                  sum += environment_map().lookup({(i + 0.5) / 8, theta / pi})[1];
                                              return sum * 2 * pi / 8 * std::sin(theta);
                                          },
                                          pi * half / 8, pi * (half + 1) / 8);
    light.largest_flux = 4 * pi * 6 * 24 * pi / 0.5;
    light.pdf_defect = "sin θ is missing.";
    light.wrong_pdf = [](Vec3, Vec3 direction, double, double pdf) {
        const double cos = environment_frame().to_local(direction).y;
        return pdf * std::sqrt(1 - cos * cos);
    };
    return light;
}

Light point() {
    Light light = light_of("point", "a point light", PointLight{{0.2, -0.3, 0.4}, radiance});
    light.hits = false;
    light.enclosing = 1.5;
    light.reference_power = 2 * 4 * pi;
    const double nearest = 1.5 - std::sqrt(0.29);
    light.largest_flux = 4 * pi * 2.25 * 2 / (nearest * nearest);
    light.pdf_defect = "1/d² is missing.";
    light.wrong_pdf = [](Vec3, Vec3, double distance, double) { return 1 / (distance * distance); };
    return light;
}

}  // namespace

const Frame& environment_frame() {
    static const Frame frame = [] {
        const double c = std::cos(0.7), s = std::sin(0.7);
        return Frame({c, s, 0}, {-s, c, 0}, {0, 0, 1});
    }();
    return frame;
}

const EnvironmentMap& environment_map() {
    static const EnvironmentMap map(8, 4, environment_pixels(), environment_frame());
    return map;
}

Light Light::with_wrong_pdf() const {
    Light other = *this;
    other.sample = [right = *this](Vec3 from, const Point<2>& u) {
        auto sample = right.sample(from, u);
        if (sample) sample->pdf = right.wrong_pdf(from, sample->direction, sample->distance, sample->pdf);
        return sample;
    };
    other.hit = [right = *this](Vec3 from, Vec3 direction) {
        auto hit = right.hit(from, direction);
        if (hit) hit->pdf = right.wrong_pdf(from, direction, hit->distance, hit->pdf);
        return hit;
    };
    return other;
}

std::vector<Light> lights() {
    return {rectangle(), disk(), mesh(), sphere(), inward_sphere(), constant(), environment(), point()};
}

}  // namespace plumb::suites
