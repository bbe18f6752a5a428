// Maps from the unit square to shapes: the density stated is 1/Jacobian, and the inverse undoes the map and makes
// samples uniform again.

#include "estimators/densities/warps.h"

#include "verification/claim.h"
#include "verification/evidence/distribution.h"
#include "verification/suites/lights/jacobian.h"

namespace plumb::suites {
namespace {

using Sample = std::function<Vec3(const Point<2>&)>;

struct WarpCase {
    std::string name, title, source;
    Sample sample;
    std::function<double(Vec3)> pdf;
    std::function<Point<2>(Vec3)> invert;
    std::function<double(Vec3)> wrong_pdf;
    std::string pdf_defect;
    Sample wrong_sample;
    std::string sample_defect;
};

Vec3 flat(const Point<2>& p) {
    return {p[0], p[1], 0};
}
Point<2> plane(Vec3 p) {
    return {p.x, p.y};
}

std::vector<WarpCase> warp_cases() {
    constexpr double cone = 0.4;
    return {
        {"polar-disk", "the polar map to the disk", "[Shirley & Chiu 1997]",
         [](const Point<2>& u) { return flat(sample_polar_disk(u)); }, [](Vec3 p) { return polar_disk_pdf(plane(p)); },
         [](Vec3 p) { return invert_polar_disk(plane(p)); }, [](Vec3 p) { return 1 / (2 * pi * std::hypot(p.x, p.y)); },
         "The density is that of r = u.",
         [](const Point<2>& u) {
             return Vec3{u[0] * std::cos(2 * pi * u[1]), u[0] * std::sin(2 * pi * u[1]), 0};
         },
         "r = u instead of √u."},
        {"concentric-disk", "the concentric map to the disk", "[Shirley & Chiu 1997]",
         [](const Point<2>& u) { return flat(sample_concentric_disk(u)); },
         [](Vec3 p) { return concentric_disk_pdf(plane(p)); }, [](Vec3 p) { return invert_concentric_disk(plane(p)); },
         [](Vec3) { return 4 / pi / 4 * 1.1; }, "The density is a tenth too large.",
         [](const Point<2>& u) {
             const double x = 2 * u[0] - 1, y = 2 * u[1] - 1;
             return Vec3{x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2), 0};
         },
         "The elliptical map, which does not keep area."},
        {"cosine-hemisphere", "the cosine-weighted hemisphere", "Malley", sample_cosine_hemisphere,
         cosine_hemisphere_pdf, invert_cosine_hemisphere, [](Vec3) { return 1 / (2 * pi); },
         "The density of a uniform hemisphere.", [](const Point<2>& u) { return sample_uniform_cone(u, 1); },
         "Uniform on the hemisphere."},
        {"uniform-sphere", "the uniform sphere", "Archimedes", sample_uniform_sphere, uniform_sphere_pdf,
         invert_uniform_sphere, [](Vec3) { return 1 / (2 * pi); }, "The density of a hemisphere.",
         [](const Point<2>& u) {
             const double theta = pi * u[0], phi = 2 * pi * u[1];
             return Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
         },
         "θ is uniform: sin θ is missing."},
        {"uniform-cone", "the uniform cone", "ours, estimators/densities/warps.h",
         [](const Point<2>& u) { return sample_uniform_cone(u, cone); },
         [](Vec3 d) { return uniform_cone_pdf(d, cone); }, [](Vec3 d) { return invert_uniform_cone(d, cone); },
         [](Vec3) { return 1 / (pi * cone * (2 - cone)); }, "The density on the projected disk, 1/(π sin²).",
         [](const Point<2>& u) {
             return sample_uniform_cone({u[0] * u[0], u[1]}, cone);
         },
         "The angle is uniform, to first order."},
        {"uniform-triangle", "the uniform triangle", "[Turk 1990]",
         [](const Point<2>& u) { return flat(sample_uniform_triangle(u)); },
         [](Vec3 b) { return uniform_triangle_pdf(plane(b)); },
         [](Vec3 b) { return invert_uniform_triangle(plane(b)); }, [](Vec3) { return 1.0; },
         "The density of the parallelogram.",
         [](const Point<2>& u) {
             return Vec3{u[0] * (1 - u[1]), u[0] * u[1], 0};
         },
         "The square root is missing."},
    };
}

Verdict inverse_undoes(const Sample& sample, const WarpCase& warp) {
    std::vector<BoundedCase> cases;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const Point<2> u{(i + 0.37) / 20, (j + 0.61) / 20}, back = warp.invert(sample(u));
            cases.push_back({fmt::format("u = ({}, {})", u[0], u[1]),
                             std::max(std::abs(back[0] - u[0]), std::abs(back[1] - u[1])), u[0]});
        }
    return within_bound(cases, 1e-13, "of u");
}

Verdict samples_are_uniform_again(const Sample& sample, const WarpCase& warp, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const double u = random.uniform();
        const Point<2> back = warp.invert(sample({u, random.uniform()}));
        return equal_cell(std::min(back[0], 0x1.fffffffffffffp-1), 6) +
               6 * equal_cell(std::min(back[1], 0x1.fffffffffffffp-1), 6);
    };
    return distribution_is(draw, {std::vector<double>(36, 1.0 / 36), 0.05}, run);
}

}  // namespace

void add_lights_warps(Catalogue& catalogue) {
    for (const WarpCase& warp : warp_cases()) {
        const auto jacobian = [warp](const std::function<double(Vec3)>& pdf) {
            return pdf_is_jacobian([&](const Point<2>& u) {
                const Vec3 place = warp.sample(u);
                return std::optional(Mapped{place, pdf(place)});
            });
        };
        catalogue.add({.id = "warp/" + warp.name + "/jacobian",
                       .statement = "The density of " + warp.title + " is 1/|∂x/∂u|.",
                       .source = warp.source,
                       .kind = Kind::bounded,
                       .trial = {jacobian, warp.pdf, {{"another-pdf", warp.pdf_defect, warp.wrong_pdf}}}});
        catalogue.add({.id = "warp/" + warp.name + "/inverse",
                       .statement = "The inverse of " + warp.title + " gives back u.",
                       .source = "ours, estimators/densities/warps.h",
                       .kind = Kind::bounded,
                       .trial = {[warp](const Sample& sample) { return inverse_undoes(sample, warp); },
                                 warp.sample,
                                 {{"another-sampler", warp.sample_defect, warp.wrong_sample}}}});
        const auto distorted = [warp](const Point<2>& u) { return warp.sample({std::pow(u[0], 1.15), u[1]}); };
        catalogue.add({.id = "warp/" + warp.name + "/distribution",
                       .statement = "Samples of " + warp.title + " fall into cells with the masses of its density.",
                       .source = warp.source,
                       .kind = Kind::distribution,
                       .trial = {[warp](const Sample& sample, const Run& run) {
                                     return samples_are_uniform_again(sample, warp, run);
                                 },
                                 warp.sample,
                                 {{"another-sampler", warp.sample_defect, warp.wrong_sample},
                                  {"distorted", "u0 is raised to 1.15: phi = 0.15.", distorted}}}});
    }
}

}  // namespace plumb::suites
