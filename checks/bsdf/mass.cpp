#include "checks/bsdf/mass.h"

#include <algorithm>
#include <cmath>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/cases.h"
#include "checks/bsdf/check_bsdf.h"
#include "checks/bsdf/directions.h"

namespace plumb::checks {

namespace {

std::vector<Vec3> likely_peaks(Vec3 wo, const BsdfTraits& traits, std::vector<Vec3> met) {
    const double across = wo.z > 0 ? traits.eta : 1 / traits.eta, sine = std::hypot(wo.x, wo.y) / across;
    std::vector<Vec3> places{mirrored(wo), wo, -wo, {0, 0, 1}, {0, 0, -1}};
    if (sine < 1) places.push_back({-wo.x / across, -wo.y / across, -std::copysign(std::sqrt(1 - sine * sine), wo.z)});
    for (const Vec3 place : places) {
        met.push_back(place);
        const Frame frame(place);
        for (const double step : {-traits.roughness / 2, traits.roughness / 2})
            for (const Vec3 tangent : {frame.x, frame.y}) met.push_back(normalize(place + tangent * step));
    }
    return met;
}

// What rounding does to a mean of f over directions like these: its operations err independently, and what is common
// to all directions is the work of one.
double rounding_of_mean(const std::function<double(Vec3 wo, Vec3 wi)>& f, Vec3 wo, const std::vector<Vec3>& met,
                        double epsilon) {
    constexpr std::size_t most = 64;
    double sum = 0, tried = 0;
    for (std::size_t i = 0; i < std::min(most, met.size()); ++i) {
        const double rounding = rounding_of(f, wo, met[i], epsilon) / rounding_operations;
        if (!(rounding < 0.1)) continue;  // an edge
        sum += rounding;
        ++tried;
    }
    return tried > 0 ? sum / tried : 0;
}

}  // namespace

Mass mass_of(const BsdfSubject& bsdf, const BsdfTraits& traits, const std::function<double(Vec3 wo, Vec3 wi)>& f,
             Vec3 wo, RandomStream& random, double epsilon, double largest) {
    constexpr int samples = 2048;
    constexpr std::size_t evaluations = 40'000;
    const auto at = [&](Vec3 wi) { return f(wo, wi); };
    for (int effort = 1;; effort *= 4) {
        Met met = met_by_samples(bsdf, wo, Transport::importance, random, epsilon, samples * effort);
        SphereIntegral integral(wo, at, likely_peaks(wo, traits, met.smooth),
                                evaluations * static_cast<std::size_t>(effort), largest);
        if (const double e = integral.error(); effort == 16 || !(e > 4e-3 && e < 0.3)) {
            const double rounding = rounding_of_mean(f, wo, met.smooth, epsilon);
            return {std::move(met), std::move(integral), rounding};
        }
    }
}

namespace {

// How often sample() takes a smooth and a discrete lobe, on Kronecker's lattice by the roots of x² = x + 1 for the lobe
// and of x³ = x + 1 for the direction, moved by a random start; every second point in radiance.
struct Frequencies {
    double smooth = 0, discrete = 0;
};

Frequencies frequencies(const BsdfSubject& bsdf, Vec3 wo, RandomStream& random, double epsilon) {
    constexpr std::array<double, 3> step{0.61803398874989485, 0.75487766624669276, 0.56984029099805327};
    constexpr std::uint64_t points = 1 << 14;
    const std::array<double, 3> start = uniforms(random, epsilon);
    Frequencies counted;
    for (std::uint64_t k = 0; k < points; ++k) {
        std::array<double, 3> u;
        for (std::size_t axis = 0; axis < 3; ++axis)
            u[axis] = representable(std::fmod(start[axis] + static_cast<double>(k) * step[axis], 1), epsilon);
        if (const auto sample = bsdf.sample(wo, u, k % 2 ? Transport::radiance : Transport::importance))
            ++(sample->measure == Measure::discrete ? counted.discrete : counted.smooth);
    }
    return {counted.smooth / points, counted.discrete / points};
}

}  // namespace

Verdict masses_match(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const double epsilon = epsilon_of(bsdf, traits, run);
    const std::vector<Vec3> directions = check_directions(run);
    const auto cases = gathered(directions.size(), [&](std::size_t index) {
        const Vec3 wo = representable(directions[index], epsilon);
        if (index % 3 != 0 && std::abs(wo.z) > 0.1) return std::vector<Case>{};
        RandomStream random = run.random(index);
        const Frequencies counted = frequencies(bsdf, wo, random, epsilon);
        const Mass mass = mass_of(bsdf, traits, bsdf.pdf, wo, random, epsilon);
        const double discrete = bsdf.discrete ? bsdf.discrete(wo) : mass.met.discrete();
        return std::vector<Case>{{.of = "the integral of pdf() for the share of smooth samples",
                                  .wo = wo,
                                  .found = mass.total(),
                                  .expected = counted.smooth,
                                  .error = std::abs(mass.total() - counted.smooth),
                                  .known = mass.error(),
                                  .cause = "pdf() is {} times as large as sample() needs"},
                                 {.of = bsdf.discrete ? "discrete() for the share of discrete samples"
                                                      : "what discrete samples announce for their share",
                                  .wo = wo,
                                  .found = discrete,
                                  .expected = counted.discrete,
                                  .error = std::abs(discrete - counted.discrete)}};
    });
    // the lattice resolves 1e-3, the quadrature likewise
    return judged(cases, {.bound = 4e-3, .unit = "of probability", .coarse = 0.02, .nothing = "nothing scatters"});
}

Verdict conserves_energy(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run, double tolerance) {
    const double epsilon = epsilon_of(bsdf, traits, run);
    const std::vector<Vec3> directions = check_directions(run);
    const auto cases = gathered(directions.size(), [&](std::size_t index) {
        const Vec3 wo = representable(directions[index], epsilon);
        RandomStream random = run.random(index);
        const auto value = [&](Vec3 o, Vec3 i) { return largest(bsdf.eval(o, i, Transport::importance)); };
        const Mass smooth = mass_of(bsdf, traits, value, wo, random, epsilon);
        double albedo = smooth.total();
        for (const Mirror& mirror : smooth.met.mirrors) albedo += mirror.sample.pdf * largest(mirror.sample.weight);
        const bool exact = traits.lossless && wo.z > 0;
        return std::vector<Case>{{.of = exact ? "the albedo of a lossless model" : "the albedo, at most",
                                  .wo = wo,
                                  .found = albedo,
                                  .expected = 1,
                                  .error = exact ? std::abs(albedo - 1) : std::max(0.0, albedo - 1),
                                  .known = smooth.error()}};
    });
    return judged(cases, {.bound = tolerance, .unit = "of the light", .coarse = 0.02, .nothing = "nothing scatters"});
}

}  // namespace plumb::checks
