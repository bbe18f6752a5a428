// Cameras: the density of a ray is 1/Jacobian of film to direction, connecting undoes sampling, light tracing and ray
// tracing give the same pixel, and a lens blurs a point as geometry says.

#include "analytic/irradiance.h"
#include "estimators/densities/warps.h"
#include "scenes/sensors/perspective.h"
#include "scenes/sensors/thin_lens.h"
#include "verification/claim.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/mean.h"
#include "verification/suites/lights/jacobian.h"

namespace plumb::suites {
namespace {

constexpr FilmSize size{8, 6};
constexpr double fov = 80, lens_radius = 0.3, focus = 3;

struct Camera {
    std::string name, title;
    std::function<Ray(const Point<2>& film, const Point<2>& lens)> sample_ray;
    std::function<double(const Ray&)> pdf;
    std::function<std::optional<SensorSample>(Vec3 from, const Point<2>& lens)> connect;
    double lens_area;  ///< 0: a pinhole
};

const CameraPose& pose() {
    static const CameraPose pose = look_at({1, 2, 3}, {3, 1, 7}, {0.1, 1, 0});
    return pose;
}

template <class S>
Camera camera_of(std::string name, std::string title, const S& sensor, double lens_area) {
    return {std::move(name),
            std::move(title),
            [sensor](const Point<2>& film, const Point<2>& lens) { return sensor.sample_ray(film, lens); },
            [sensor](const Ray& ray) { return sensor.pdf(ray); },
            [sensor](Vec3 from, const Point<2>& lens) { return sensor.connect(from, lens); },
            lens_area};
}

std::vector<Camera> cameras() {
    return {camera_of("perspective", "the pinhole camera", Perspective(pose(), size, fov), 0),
            camera_of("thin-lens", "the thin-lens camera", ThinLens(pose(), size, fov, lens_radius, focus),
                      pi * lens_radius * lens_radius)};
}

double cos_with_axis(Vec3 direction) {
    return std::abs(dot(direction, pose().forward));
}

Verdict density_is_jacobian(const Camera& camera) {
    const Point<2> lens{0.9, 0.3};
    return pdf_is_jacobian([&](const Point<2>& u) -> std::optional<Mapped> {
        const Ray ray = camera.sample_ray({u[0] * size.width, u[1] * size.height}, lens);
        return Mapped{ray.direction, camera.pdf(ray) / (size.width * size.height)};
    });
}

Verdict connecting_undoes_sampling(const Camera& camera) {
    std::vector<BoundedCase> cases;
    for (int i = 0; i < 400; ++i) {
        const Point<2> film{(i / 20 + 0.43) / 20 * size.width, (i % 20 + 0.57) / 20 * size.height};
        const Point<2> lens{std::fmod(0.37 * i, 1.0), std::fmod(0.61 * i, 1.0)};
        const Ray ray = camera.sample_ray(film, lens);
        const double distance = 0.5 + 0.01 * i, cos = cos_with_axis(ray.direction), pdf = camera.pdf(ray);
        const auto back = camera.connect(ray.origin + ray.direction * distance, lens);
        // W = pdf / (lens area · cos); of a pinhole W cos (lens area)/d².
        const double importance = camera.lens_area > 0 ? pdf / (camera.lens_area * cos) : pdf / (distance * distance);
        const double error =
            !back ? HUGE_VAL
                  : std::max({std::abs(back->film[0] - film[0]), std::abs(back->film[1] - film[1]),
                              std::abs(back->distance - distance), std::abs(back->importance / importance - 1)});
        cases.push_back({fmt::format("film ({}, {})", film[0], film[1]), error, film[0]});
    }
    return within_bound(cases, 1e-11, "pixels, or relative");
}

/// A plane of radiance 1 fills the view, so that every pixel is 1. The same by light tracing: points of a window of the
/// plane, connected to the lens, count when they reach the pixel: A_window · cos · W / pdf.
Verdict light_tracing_is_one(const Camera& camera, const Run& run) {
    constexpr double depth = 2, pixel = 2 * 0.83909963117728 / 8;  // tan 40°: a pixel's side in the plane at 1
    constexpr Point<2> corner{5, 1};
    // The pixel's shadow on the plane, widened by the lens' blur.
    const double blur = camera.lens_area > 0 ? lens_radius * (1 - depth / focus) : 0;
    const double left = (corner[0] - 4) * pixel * depth - blur, top = (3 - corner[1]) * pixel * depth + blur;
    const double side = pixel * depth + 2 * blur;
    const auto draw = [&](RandomStream& random) {
        const double x = left + side * random.uniform(), y = top - side * random.uniform();
        const Vec3 point = pose().position + pose().axes().to_world({x, y, depth});
        const double u = random.uniform();
        const auto seen = camera.connect(point, {u, random.uniform()});
        if (!seen || std::floor(seen->film[0]) != corner[0] || std::floor(seen->film[1]) != corner[1]) return 0.0;
        return side * side * cos_with_axis(seen->direction) * seen->importance / seen->pdf;
    };
    // cos W / pdf ≤ pixels per area / d² · 1/cos³ · cos, at most 1/(pixel² depth²) as d = depth/cos.
    const double largest = side * side / (pixel * pixel * depth * depth) * (1 + 1e-9);
    return mean_is(draw,
                   {.reference = 1,
                    .delta = 0.01,
                    .epsilon = 1e-9,
                    .bounds = {0, largest},
                    .zero_variance = camera.lens_area == 0},
                   run);
}

Camera with_pdf(Camera camera, const std::function<double(const Ray&, double pdf)>& change) {
    camera.pdf = [pdf = camera.pdf, change](const Ray& ray) { return change(ray, pdf(ray)); };
    return camera;
}
Camera with_sample(Camera camera, const std::function<void(SensorSample&)>& change) {
    camera.connect = [connect = camera.connect, change](Vec3 from, const Point<2>& lens) {
        auto sample = connect(from, lens);
        if (sample) change(*sample);
        return sample;
    };
    return camera;
}
Camera shifted(Camera camera, double pixels) {
    camera.sample_ray = [ray = camera.sample_ray, pixels](const Point<2>& film, const Point<2>& lens) {
        return ray({film[0] + pixels, film[1] + pixels}, lens);
    };
    return camera;
}

void add_one(Catalogue& catalogue, const Camera& camera) {
    const std::string id = "camera/" + camera.name;
    const Camera cosine =
        with_pdf(camera, [](const Ray& ray, double pdf) { return pdf * cos_with_axis(ray.direction); });
    catalogue.add({.id = id + "/jacobian",
                   .statement = "The density of rays of " + camera.title + " is 1/|∂ω/∂film|.",
                   .source = "ours, scenes/sensors/film_plane.h",
                   .kind = Kind::bounded,
                   .trial = {density_is_jacobian, camera, {{"cosine-squared", "1/cos² instead of 1/cos³.", cosine}}}});
    catalogue.add({.id = id + "/connect",
                   .statement = "Connecting " + camera.title +
                                " to a point of a ray gives back its film point, and importance pdf/(A cos θ).",
                   .source = "ours, scenes/sensors/sensor.h",
                   .kind = Kind::bounded,
                   .trial = {connecting_undoes_sampling,
                             camera,
                             {{"half-pixel", "Rays start half a pixel aside.", shifted(camera, 0.5)},
                              {"cosine-squared", "1/cos² instead of 1/cos³.", cosine}}}});
    catalogue.add({.id = id + "/light-tracing",
                   .statement = "A pixel of " + camera.title + " that sees radiance 1 is 1 by light tracing too.",
                   .source = "ours, scenes/sensors/sensor.h",
                   .kind = Kind::mean,
                   .trial = {light_tracing_is_one,
                             camera,
                             {{"without-distance", "d² is missing.",
                               with_sample(camera, [](SensorSample& s) { s.importance *= s.distance * s.distance; })},
                              {"cosine", "A cosine too many at the camera.", with_sample(camera, [](SensorSample& s) {
                                   s.importance *= cos_with_axis(s.direction);
                               })}}}});
}

// ---- the circle of confusion

using LensMap = std::function<Point<2>(const Point<2>&)>;

/// The point, in units of the circle's radius, where the film sees a point off the axis at twice the focus through the
/// lens point u.
Point<2> blurred(const Point<2>& u, double focus_of_lens = focus) {
    const ThinLens lens(pose(), size, fov, lens_radius, focus_of_lens);
    const Perspective pinhole(pose(), size, fov);
    const Vec3 point = pose().position + pose().axes().to_world({0.3, -0.4, 2 * focus});
    const Point<2> sharp = pinhole.connect(point, u)->film, seen = lens.connect(point, u)->film;
    const double pixels = size.width / (2 * std::tan(fov * pi / 360));  // per unit in the plane at 1
    const double radius = circle_of_confusion(lens_radius, focus, 2 * focus) / focus * pixels;
    return {(seen[0] - sharp[0]) / radius, (seen[1] - sharp[1]) / radius};
}

Verdict rim_maps_to_circle(double focus_of_lens) {
    std::vector<BoundedCase> cases;
    for (int i = 0; i < 100; ++i) {
        const Point<2> p = blurred({0, i / 100.0}, focus_of_lens);  // an edge of the square goes to the rim
        cases.push_back({fmt::format("rim at {}", i), std::abs(std::hypot(p[0], p[1]) - 1), i / 100.0});
    }
    return within_bound(cases, 1e-10, "of the radius");
}

Verdict circle_is_filled(const LensMap& map, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const double u = random.uniform();
        const Point<2> p = blurred(map({u, random.uniform()})), back = invert_polar_disk(p);
        return std::min<std::size_t>(5, static_cast<std::size_t>(back[0] * 6)) + 6 * equal_cell(back[1], 4);
    };
    return distribution_is(draw, {std::vector<double>(24, 1.0 / 24), 0.05}, run);
}

/// The numbers that give the lens point at radius u^exponent and angle 2πu: exponent ½ is uniform.
LensMap radius_power(double exponent) {
    return [exponent](const Point<2>& u) {
        const double r = std::pow(u[0], exponent), phi = 2 * pi * u[1];
        return invert_concentric_disk({r * std::cos(phi), r * std::sin(phi)});
    };
}

void add_blur(Catalogue& catalogue) {
    catalogue.add(
        {.id = "camera/thin-lens/circle-of-confusion",
         .statement = "Through the rim of a thin lens a point is seen on the circle of confusion.",
         .source = "analytic/irradiance.h",
         .kind = Kind::bounded,
         .trial = {
             rim_maps_to_circle, focus, {{"out-of-focus", "The lens is in focus 1 % further away.", 1.01 * focus}}}});
    catalogue.add({.id = "camera/thin-lens/blur",
                   .statement = "A thin lens spreads a point evenly over its circle of confusion.",
                   .source = "ours, scenes/sensors/thin_lens.cpp",
                   .kind = Kind::distribution,
                   .trial = {circle_is_filled,
                             [](const Point<2>& u) { return u; },
                             {{"wrong-jacobian", "r = u instead of √u on the lens.", radius_power(1)},
                              {"slightly-wrong", "r = u^0.575: phi = 0.15.", radius_power(0.575)}}}});
}

}  // namespace

void add_film_cameras(Catalogue& catalogue) {
    for (const Camera& camera : cameras()) add_one(catalogue, camera);
    add_blur(catalogue);
}

}  // namespace plumb::suites
