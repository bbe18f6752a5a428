#include "verification/suites/shift/shift_subjects.h"

#include "estimators/densities/warps.h"

namespace plumb::suites {

namespace {

void add_plate(description::Scene& scene, Vec3 corner, Vec3 edge_1, Vec3 edge_2, description::MaterialId material,
               std::optional<double> radiance = {}) {
    add_polygon(scene, {corner, corner + edge_1, corner + edge_1 + edge_2, corner + edge_2}, material,
                radiance ? std::optional(Spectrum::grey(*radiance)) : std::nullopt);
}

}  // namespace

const Scene& curtain_scene() {
    static const Scene scene([] {
        description::Scene room;
        const auto white = add_material(room, description::Diffuse{Spectrum::rgb(0.8, 0.6, 0.4)});
        const auto sides = add_material(room, description::TwoSided{white, white});
        const auto curtain = add_material(room, description::Mask{Spectrum::grey(0.5), sides});
        add_plate(room, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, white);
        add_plate(room, {-2, 2, 0}, {4, 0, 0}, {0, 0, 3}, white);
        add_plate(room, {0.2, -1, 0.1}, {0, 2.5, 0}, {0, 0, 1.5}, curtain);
        add_plate(room, {0.8, -0.5, 2.5}, {0, 1, 0}, {1, 0, 0}, white, 8.0);
        room.sensor = camera({-1.5, -3.5, 1.6}, {0.1, 0.5, 0.5}, 50, 32, 32);
        return room;
    }());
    return scene;
}

const Scene& metal_scene() {
    static const Scene scene([] {
        description::Scene room;
        const auto floor = add_material(room, description::Diffuse{Spectrum::grey(0.6)});
        const auto metal = add_material(
            room, description::Conductor{Spectrum::rgb(0.2, 0.9, 1.1), Spectrum::rgb(3.9, 2.4, 2.2), Spectrum::grey(1),
                                         description::Roughness{description::Microfacets::ggx, 0.4}});
        add_plate(room, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, metal);
        add_plate(room, {-2, 2, 0}, {4, 0, 0}, {0, 0, 3}, floor);
        add_plate(room, {-1.9, -1.5, 0.2}, {0, 3, 0}, {0, 0, 2}, floor, 2.0);
        room.sensor = camera({1.2, -3.5, 1.6}, {-0.2, 0.5, 0.4}, 50, 32, 32);
        return room;
    }());
    return scene;
}

std::vector<std::pair<std::string, PixelPair>> shift_scenes() {
    using Source = PathClass::Source;
    const FilmRegion left{1, 3, 6, 10}, right{9, 3, 6, 10};
    return {{"box", {box_scene(), {8, 20, 1, 1}, {20, 26, 1, 1}}},
            {"rough", {rough_scene(), {4, 14, 8, 8}, {18, 18, 8, 8}}},
            {"into glass", {rough_scene(), {8, 12, 4, 4}, {13, 14, 6, 6}}},
            {"metal", {metal_scene(), {14, 24, 1, 1}, {18, 20, 1, 1}}},
            {"glass", {glass_scene(Source::surface), left, right}},
            {"glass and sky", {glass_scene(Source::environment), left, right}},
            {"curtain", {curtain_scene(), {12, 18, 1, 1}, {20, 24, 1, 1}}},
            {"point", {sphere_around_point(), {0, 0, 1, 1}, {3, 2, 1, 1}}},
            {"leaning normals", {smooth_normals_scene(), {14, 16, 1, 1}, {18, 18, 1, 1}}}};
}

void Replaced::set(Slot slot, const std::array<double, 2>& u) {
    const auto found = std::ranges::find(replaced_, slot, &std::pair<Slot, Drawn>::first);
    if (found == replaced_.end())
        replaced_.push_back({slot, {u}});
    else
        found->second = {u};
}

Drawn Replaced::at(Slot slot) {
    const auto found = std::ranges::find(replaced_, slot, &std::pair<Slot, Drawn>::first);
    return found == replaced_.end() ? rest_.at(slot) : found->second;
}

namespace {

using Numbers = LobeNumbers;

// By how far the sample of these numbers misses a local direction, along two axes across it.
struct Miss {
    Point<2> across{};
    double length = HUGE_VAL;
};
Miss miss(const PathVertex& vertex, const Frame& target, const Numbers& u) {
    const auto sample = vertex.bsdf.sample(vertex.to_local(vertex.wo), u, Transport::radiance);
    if (!sample || sample->measure != Measure::solid_angle || !(dot(sample->wi, target.z) > 0)) return {};
    const Vec3 local = target.to_local(sample->wi);
    return {{local.x, local.y}, std::hypot(local.x, local.y)};
}

// The best of a grid.
Numbers nearest_start(const PathVertex& vertex, const Frame& target, double lobe) {
    constexpr int grid = 24;
    Numbers best{lobe, 0.5, 0.5};
    double least = HUGE_VAL;
    for (int i = 0; i < grid * grid; ++i) {
        const Numbers u{lobe, (i % grid + 0.5) / grid, (std::floor(i / grid) + 0.5) / grid};
        if (const double length = miss(vertex, target, u).length; length < least) least = length, best = u;
    }
    return best;
}

std::optional<Numbers> by_newton(const PathVertex& vertex, const Frame& target, Numbers u) {
    constexpr double h = 1e-6, close = 1e-12;
    for (int step = 0; step < 40; ++step) {
        const Miss here = miss(vertex, target, u);
        if (here.length <= close) return u;
        std::array<Point<2>, 2> slope{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            Numbers after = u, before = u;
            after[axis + 1] += h, before[axis + 1] -= h;
            const Point<2> a = miss(vertex, target, after).across, b = miss(vertex, target, before).across;
            slope[axis] = {(a[0] - b[0]) / (2 * h), (a[1] - b[1]) / (2 * h)};
        }
        const double determinant = slope[0][0] * slope[1][1] - slope[1][0] * slope[0][1];
        const Point<2> way{(here.across[0] * slope[1][1] - here.across[1] * slope[1][0]) / determinant,
                           (here.across[1] * slope[0][0] - here.across[0] * slope[0][1]) / determinant};
        double damped = 1;
        const auto moved = [&] {
            return Numbers{u[0], std::clamp(u[1] - damped * way[0], 0.0, 1 - 0x1p-53),
                           std::clamp(u[2] - damped * way[1], 0.0, 1 - 0x1p-53)};
        };
        while (damped > 1e-4 && !(miss(vertex, target, moved()).length < here.length)) damped /= 2;
        u = moved();
    }
    return miss(vertex, target, u).length <= 1e-9 ? std::optional(u) : std::nullopt;
}

}  // namespace

std::optional<Numbers> numbers_towards(const PathVertex& vertex, Vec3 direction, const std::optional<Numbers>& near) {
    constexpr double last = 1 - 0x1p-53;
    const Vec3 wi = vertex.to_local(direction);
    const Frame target(wi);
    // A cosine lobe is the last, and mirrored with its model.
    const Point<2> cosine = invert_cosine_hemisphere({wi.x, wi.y, std::abs(wi.z)});
    if (const Numbers u{last, cosine[0], cosine[1]}; miss(vertex, target, u).length < 1e-9) return u;
    if (near) return by_newton(vertex, target, *near);
    for (const double lobe : {0.0, last})
        if (const auto u = by_newton(vertex, target, nearest_start(vertex, target, lobe))) return u;
    return {};
}

namespace {

Vec3 turned_by(Vec3 direction, const Point<2>& angles) {
    const Frame across(direction);
    return normalize(direction + across.x * angles[0] + across.y * angles[1]);
}

}  // namespace

std::optional<NumbersOfShift> numbers_of_shift(const Scene& scene, const BasePath& base, const ShiftedPath& shifted,
                                               const Turned& turned, const NumbersOfShift& near) {
    const std::size_t k = base.connection;
    if (k == 0 || shifted.parts.size() <= k || !shifted.parts[k].valid()) return {};
    const PathVertex& from = shifted.record.vertices[k - 1];
    const auto& scatterings = base.story.scatterings;
    const bool escapes = base.record.vertices.size() <= k;
    const Connection edge = escapes ? connection_to_environment(from, scatterings[k - 1].direction)
                                    : connection_to(scene, from, base.record.vertices[k].hit);
    NumbersOfShift numbers{numbers_towards(from, turned_by(edge.direction, turned.at_connection), near.at_connection),
                           {}};
    if (!numbers.at_connection) return {};
    if (!escapes && scatterings.size() > k && scatterings[k].measure == Measure::solid_angle)
        numbers.beyond = numbers_towards(*edge.end, turned_by(scatterings[k].direction, turned.beyond), near.beyond);
    return numbers;
}

std::unique_ptr<PathShift> hybrid(const PathTracer& tracer) {
    return tracer.shift();
}

MakeShift hybrid_by(ConnectionDensity density, ConnectionDensity beyond) {
    return [=](const PathTracer& tracer) {
        auto shift = std::make_unique<HybridShift>(tracer);
        shift->density = density;
        shift->beyond = beyond;
        return shift;
    };
}

std::unique_ptr<PathShift> asymmetric(const PathTracer& tracer) {
    auto shift = std::make_unique<HybridShift>(tracer);
    shift->earlier = [](const ConnectionLimits&, const PathVertex&, const PathVertex*) {
        return ShiftFailure::too_near;
    };
    return shift;
}

namespace {

struct ValidByPath final : PathShift {
    HybridShift inner;

    explicit ValidByPath(const PathTracer& tracer) : inner(tracer) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const override {
        inner.trace(scene, region, samples, base);
    }
    void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
               ShiftedPath& shifted) const override {
        inner.shift(scene, base, region, samples, shifted);
        const auto failed = std::ranges::find_if_not(shifted.parts, &ShiftedPart::valid);
        if (failed == shifted.parts.end()) return;
        const ShiftedPart part = *failed;
        std::ranges::fill(shifted.parts, part);
        shifted.splats.clear();
    }
};

}  // namespace

std::unique_ptr<PathShift> valid_by_path(const PathTracer& tracer) {
    return std::make_unique<ValidByPath>(tracer);
}

}  // namespace plumb::suites
