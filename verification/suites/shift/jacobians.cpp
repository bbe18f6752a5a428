// Jacobians of the hybrid shift against differences.
//
// A shift makes numbers v of the path y from numbers u of its base x. All are kept but those of the directions at the
// connection and behind it, and those before it decide where x_k and y_k are: the matrix of all derivatives is block
// triangular, and J the product of both blocks' determinants. Both paths share the vertex z = x_{k+1}, which moves on
// its tangent plane, and the direction ω at z. By the chain rule
//   |∂v/∂u| at k      =  |∂ω_x/∂u| / |∂ω_x/∂z| · |∂ω_y/∂z| / |∂ω_y/∂v|,      ω_x = x_k → z, ω_y = y_k → z,
//   |∂v/∂u| behind it =  |∂ω/∂u| / |∂ω/∂v|.
// Each factor is of a map in doubles, the sample of a BSDF as a function of its numbers or a direction as a function of
// z: rays, which are rounded to floats, play no part, and steps can be small. That `path` goes where these maps say is
// for shift/path/there-and-back to show.

#include "verification/evidence/deterministic.h"
#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

// A positive number, and how far it may be off, relative to it.
struct Bounded {
    double value = 1, error = 0;

    friend Bounded operator*(const Bounded& a, const Bounded& b) { return {a.value * b.value, a.error + b.error}; }
    friend Bounded operator/(const Bounded& a, const Bounded& b) { return {a.value / b.value, a.error + b.error}; }
};

// |determinant| of the derivatives of a map from the plane to the plane; at(axis, s) is its value a step s away.
//
// Central differences are D(h) = f' + h² f'''/6 + O(h⁴): (4 D(h/2) − D(h))/3 is free of h², and |D(h/2) − D(h)|/3,
// which it takes off D(h/2), bounds what is left where h is small beside the distance L to where f is not analytic. Of
// h = L/1024 what is left is (h/L)⁴ = 2^-40 of f', less than the rounding, which counts where f''' happens to vanish:
// `rounding` of a value makes 3/h of itself.
constexpr double steps_to_edge = 1024;
template <class Map>
Bounded area_ratio(const Map& at, double step, double rounding) {
    std::array<Point<2>, 2> slopes{}, errors{};
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t row = 0; row < 2; ++row) {
            const auto slope = [&](double h) { return (at(axis, h)[row] - at(axis, -h)[row]) / (2 * h); };
            const double wide = slope(step), narrow = slope(step / 2);
            slopes[axis][row] = (4 * narrow - wide) / 3;
            errors[axis][row] = std::abs(narrow - wide) / 3 + rounding * (1 + std::abs(narrow)) * 3 / step;
        }
    const auto off = [&](std::size_t i, std::size_t j) {  // of the product of the entries (0, i) and (1, j)
        return std::abs(slopes[0][i]) * errors[1][j] + std::abs(slopes[1][j]) * errors[0][i] +
               errors[0][i] * errors[1][j];
    };
    const double determinant = std::abs(slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0]);
    return {determinant, (off(0, 1) + off(1, 0)) / determinant};
}

// |∂ω/∂u| of the numbers that lead from a vertex in a direction. A sample is as exact as if its numbers were off by a
// few units in the last place; the numbers themselves miss the direction a little, which the determinant feels over the
// distance L.
Bounded solid_angle(const PathVertex& vertex, Vec3 direction, const std::array<double, 3>& numbers) {
    constexpr double rounding = 0x1p-48;
    const Frame across(vertex.to_local(direction));
    const auto at = [&](std::size_t axis, double step) -> Point<2> {
        std::array<double, 3> moved = numbers;
        moved[axis + 1] += step;
        const auto sample = vertex.bsdf.sample(vertex.to_local(vertex.wo), moved, Transport::radiance);
        if (!sample) return {NAN, NAN};
        const Vec3 local = across.to_local(sample->wi);
        return {local.x, local.y};
    };
    const double a = 2 * numbers[1] - 1, b = 2 * numbers[2] - 1;
    // To the square's border, and to the diagonals that part the pieces of its map to the disk.
    const double edge = std::min({1 - std::abs(a), 1 - std::abs(b), std::abs(a + b) / 2, std::abs(a - b) / 2}) / 2;
    Bounded area = area_ratio(at, edge / steps_to_edge, rounding);
    const Point<2> miss = at(0, 0);
    area.error += 8 * std::hypot(miss[0], miss[1]) / (edge * std::min(1.0, area.value));
    return area;
}

// |∂ω/∂z| of an edge to a vertex that moves on its tangent plane; 1 where the direction itself is kept.
Bounded solid_angle(const PathVertex& from, const Connection& edge) {
    if (!edge.end) return {};
    const Vec3 origin = from.hit.point.position, end = edge.end->hit.point.position;
    const Frame across(edge.direction), plane(edge.end->hit.point.normal);
    const auto at = [&](std::size_t axis, double step) -> Point<2> {
        const Vec3 moved = end + (axis == 0 ? plane.x : plane.y) * (step * edge.distance);
        const Vec3 local = across.to_local(normalize(moved - origin));
        return {local.x, local.y};
    };
    const double rounding = 0x1p-48 * (1 + (length(origin) + length(end)) / edge.distance);
    Bounded area = area_ratio(at, 1 / steps_to_edge, rounding);
    area.value /= edge.distance * edge.distance;
    return area;
}

// A lobe of which the numbers of a direction are a smooth function: mixtures have several numbers for a direction.
bool single_lobe(const PathVertex& vertex) {
    return std::holds_alternative<Diffuse>(vertex.bsdf.model) ||
           std::holds_alternative<RoughConductor>(vertex.bsdf.model);
}

// |∂v/∂u| of the numbers that lead in a direction at a vertex of either path.
std::optional<Bounded> ratio_of_numbers(const PathVertex& of_base, Vec3 base_direction, const PathVertex& of_shifted,
                                        Vec3 shifted_direction) {
    if (!single_lobe(of_base) || !single_lobe(of_shifted)) return {};
    const auto u = numbers_towards(of_base, base_direction), v = numbers_towards(of_shifted, shifted_direction);
    if (!u || !v) return {};
    return solid_angle(of_base, base_direction, *u) / solid_angle(of_shifted, shifted_direction, *v);
}

// Of the parts at the connection and behind it, in that order, as far as differences are known.
std::vector<Bounded> jacobians_by_differences(const Scene& scene, const BasePath& base, const ShiftedPath& shifted) {
    const std::size_t k = base.connection;
    if (k == 0 || shifted.parts.size() <= k || !shifted.parts[k].valid()) return {};
    const PathVertex &x = base.record.vertices[k - 1], &y = shifted.record.vertices[k - 1];
    const bool escapes = base.record.vertices.size() <= k;
    const auto edge = [&](const PathVertex& from) {
        return escapes ? connection_to_environment(from, base.story.scatterings[k - 1].direction)
                       : connection_to(scene, from, base.record.vertices[k].hit);
    };
    const Connection from_x = edge(x), from_y = edge(y);
    const auto numbers = ratio_of_numbers(x, from_x.direction, y, from_y.direction);
    if (!numbers) return {};
    std::vector<Bounded> found{*numbers * (solid_angle(y, from_y) / solid_angle(x, from_x))};
    if (escapes || base.parts <= k + 1 || !shifted.parts[k + 1].valid()) return found;
    const Vec3 onwards = base.story.scatterings[k].direction;
    if (const auto beyond = ratio_of_numbers(*from_x.end, onwards, *from_y.end, onwards))
        found.push_back(found.front() * *beyond);
    return found;
}

Verdict jacobians_are_differences(const MakeShift& make, const Run& run) {
    const PathTracer tracer;
    const auto shift = make(tracer);
    HeldCases cases;
    BasePath base;
    ShiftedPath shifted;
    const std::uint64_t seed = run.random(0).bits();
    for (const auto& [name, pixels] : shift_scenes())
        for (std::uint32_t i = 0; i < run.pick(150u, 2'000u); ++i) {
            run.end_if_stopped();
            IndependentSamples numbers({seed, 0, i});
            shift->trace(pixels.scene, pixels.from, numbers, base);
            shift->shift(pixels.scene, base, pixels.to, numbers, shifted);
            std::size_t part = base.connection;
            for (const Bounded& truth : jacobians_by_differences(pixels.scene, base, shifted)) {
                const double error = std::abs(shifted.parts[part].jacobian / truth.value - 1);
                cases.add(fmt::format("{}, sample {}, part {}", name, i, part++), error, truth.error);
            }
        }
    return cases.verdict();
}

double without_density(const Connection&) {
    return 1;
}

}  // namespace

void add_shift_jacobians(Catalogue& catalogue) {
    catalogue.add({.id = "shift/path/jacobian",
                   .statement =
                       "The Jacobian of a shift is the determinant of the derivatives of the numbers that lead to the "
                       "shifted path by those that lead to its base, within the error of differences.",
                   .source = "ours, integrators/estimators/hybrid_shift.h",
                   .kind = Kind::bounded,
                   .trial = {jacobians_are_differences,
                             hybrid,
                             {{"dropped", "The Jacobian is 1.", (hybrid_by(without_density, without_density))},
                              {"inverted", "The Jacobian is that of the shift back.",
                               (hybrid_by([](const Connection& c) { return 1 / connection_density(c); },
                                          [](const Connection& c) { return 1 / density_beyond(c); }))},
                              {"no-cos", "The Jacobian lacks the cosines at the far end.",
                               (hybrid_by([](const Connection& c) { return c.pdf / (c.distance * c.distance); }))},
                              {"no-distance", "The Jacobian lacks the squared distances.",
                               (hybrid_by([](const Connection& c) { return c.pdf * c.cos; }))},
                              {"no-pdf", "The Jacobian lacks the ratio of densities at the connection.",
                               (hybrid_by([](const Connection& c) { return c.cos / (c.distance * c.distance); }))},
                              {"no-pdf-beyond", "The Jacobian lacks the ratio of densities behind the connection.",
                               (hybrid_by(connection_density, without_density))}}}});
}

}  // namespace plumb::suites
