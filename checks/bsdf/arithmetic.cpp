#include "checks/bsdf/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/bsdf/directions.h"
#include "core/error.h"

namespace plumb::checks {
namespace {

constexpr double doubles = 0x1p-53, floats = 0x1p-24;
constexpr double infinity = std::numeric_limits<double>::infinity();

double as_float(double x) {
    return static_cast<double>(static_cast<float>(x));
}

bool is_float(double x) {
    return as_float(x) == x;
}

// |second difference| + (first difference)² of ln f along one tangent.
double bend(double before, double here, double after) {
    if (!(before > 0 && after > 0)) return infinity;
    const double down = std::log(before / here), up = std::log(after / here);
    return std::abs(up + down) + std::pow((up - down) / 2, 2);
}

}  // namespace

void require_valid(const BsdfTraits& traits) {
    const auto& [roughness, eta, lossless, epsilon] = traits;
    if (!(roughness >= 1e-6 && roughness <= 1))
        throw Error(fmt::format(
            "roughness is {}; accepted: 1e-6 to 1, the narrowest smooth lobe's, 1 where all are discrete", roughness));
    if (!(eta > 0 && std::isfinite(eta))) throw Error(fmt::format("eta is {}; an index above 0 is accepted", eta));
    if (!(epsilon == 0 || (epsilon >= doubles && epsilon <= 0x1p-11)))
        throw Error(fmt::format("epsilon is {}; accepted: 0, or 2^-53 (doubles) to 2^-11 (half floats)", epsilon));
}

double epsilon_of(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    require_valid(traits);
    if (traits.epsilon > 0) return traits.epsilon;
    constexpr int tries = 256;
    int directions = 0, densities = 0;
    bool float_directions = true, float_densities = true;
    const Run part = run.part("epsilon");
    for (int i = 0; i < tries; ++i) {
        RandomStream random = part.random(static_cast<std::uint64_t>(i));
        const Vec3 wo = any_direction(random);
        const auto sample = bsdf.sample(wo, uniforms(random, doubles), Transport::importance);
        if (!sample) continue;
        ++directions;
        float_directions &= is_float(sample->wi.x) && is_float(sample->wi.y) && is_float(sample->wi.z);
        if (sample->measure == Measure::discrete) continue;
        ++densities;
        float_densities &= is_float(sample->pdf);
    }
    return (directions > 0 && float_directions) || (densities > 0 && float_densities) ? floats : doubles;
}

Vec3 representable(Vec3 w, double epsilon) {
    return epsilon > doubles ? Vec3{as_float(w.x), as_float(w.y), as_float(w.z)} : w;
}

double representable(double u, double epsilon) {
    return epsilon > doubles ? std::floor(u * 0x1p24) * 0x1p-24 : u;
}

std::array<double, 3> uniforms(RandomStream& random, double epsilon) {
    return {representable(random.uniform(), epsilon), representable(random.uniform(), epsilon),
            representable(random.uniform(), epsilon)};
}

double resolution(double for_doubles, double epsilon) {
    return std::max(for_doubles, 64 * epsilon);
}

double rounding_of(const std::function<double(Vec3 wo, Vec3 wi)>& f, Vec3 wo, Vec3 wi, double epsilon) {
    const double step = std::sqrt(epsilon), here = f(wo, wi);
    const auto moved = [&](Vec3 w, Vec3 tangent, double by) {
        return representable(normalize(w + tangent * by), epsilon);
    };
    if (!(here > 0)) return infinity;
    double sum = epsilon;
    for (const Vec3 t : {Frame(wi).x, Frame(wi).y})
        sum += bend(f(wo, moved(wi, t, -step)), here, f(wo, moved(wi, t, step)));
    for (const Vec3 t : {Frame(wo).x, Frame(wo).y})
        sum += bend(f(moved(wo, t, -step), wi), here, f(moved(wo, t, step), wi));
    return rounding_operations * sum;
}

}  // namespace plumb::checks
