#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/cases.h"
#include "checks/bsdf/check_bsdf.h"
#include "checks/bsdf/directions.h"
#include "checks/bsdf/factors.h"
#include "checks/bsdf/lobes.h"
#include "core/parallel.h"

namespace plumb::checks {
namespace {

constexpr double bound = 1e-5;

struct Area {
    double value, error;  // the error relative
};

// The sampled direction as a function of u[1] and u[2], within one lobe; empty outside.
using Map = std::function<std::optional<Vec3>(double u1, double u2)>;

// |∂wi/∂u1 × ∂wi/∂u2| by central differences of fourth order at one step; the error is that of rounded directions.
std::optional<Area> area_at(const Map& map, const std::array<double, 2>& u, double h, double epsilon) {
    std::array<Vec3, 2> derivative;
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (const auto& [steps, factor] : {std::pair{1, 8.0}, {-1, -8.0}, {2, -1.0}, {-2, 1.0}}) {
            std::array<double, 2> v = u;
            v[axis] += steps * h;
            if (!(v[axis] > 0 && v[axis] < 1)) return {};
            const auto there = map(v[0], v[1]);
            if (!there) return {};
            derivative[axis] += *there * (factor / (12 * h));
        }
    const double value = length(cross(derivative[0], derivative[1]));
    const double rounded = rounding_operations * epsilon * 1.5 / h * (length(derivative[0]) + length(derivative[1]));
    return Area{value, value > 0 ? rounded / value : std::numeric_limits<double>::infinity()};
}

// The same at steps 2^-3, 2^-4, … 2^-18, by the one whose last two changes and rounding are least: a change is what the
// longer step had truncated, or what rounding does to both; two, because one may be small by chance. Steps are powers
// of two and u is a multiple of 2^-18, so that floats take them unrounded.
std::optional<Area> jacobian(const Map& map, const std::array<double, 2>& u, double epsilon) {
    std::optional<Area> best;
    std::vector<double> ladder;
    for (int step = 3; step <= 18; ++step) {
        const auto next = area_at(map, u, std::ldexp(1.0, -step), epsilon);
        if (!next) continue;
        if (best && next->error > best->error) break;
        ladder.push_back(next->value);
        if (ladder.size() < 3) continue;
        const double* last = &ladder.back();
        const double changes = std::abs(last[0] - last[-1]) + std::abs(last[-1] - last[-2]);
        const double error = changes / next->value + next->error;
        if (!best || error < best->error) best = Area{next->value, error};
    }
    return best;
}

// Whether another lobe may send samples where this one's go: another interval of u[0] that is smooth, unless it is on
// the other side of an interface, or that is lost, and may not be at another u.
bool may_overlap(const std::vector<Lobe>& all, const Lobe& lobe) {
    return std::ranges::any_of(all, [&](const Lobe& other) {
        if (&other == &lobe || other.discrete()) return false;
        if (!other.sample) return true;
        return same_side(other.sample->wi, lobe.sample->wi) || other.sample->eta == lobe.sample->eta;
    });
}

struct Question {
    Vec3 wo;
    std::array<double, 2> u;
    double offset;
};

Question question(const Run& run, std::size_t index, double epsilon) {
    RandomStream random = run.random(index);
    const Vec3 wo = representable(any_direction(random), epsilon);
    const auto multiple = [&] { return std::round(0x1p18 * (0.02 + 0.96 * random.uniform())) * 0x1p-18; };
    const double first = multiple(), second = multiple();
    return {wo, {first, second}, random.uniform()};
}

std::vector<Case> answers(const BsdfSubject& bsdf, const Question& q, double epsilon, int probes) {
    std::vector<Case> cases;
    const std::vector<Lobe> all = lobes(bsdf, q.wo, q.u, Transport::importance, q.offset, probes);
    for (const Lobe& lobe : all) {
        if (!lobe.smooth()) continue;
        const double u0 = representable(lobe.middle(), epsilon);
        const auto area = jacobian(
            [&](double u1, double u2) -> std::optional<Vec3> {
                const auto there = bsdf.sample(q.wo, {u0, u1, u2}, Transport::importance);
                return same_lobe(there, lobe.sample) ? std::optional(there->wi) : std::nullopt;
            },
            q.u, epsilon);
        if (!area || !(area->value > 0)) continue;
        Case c = equal("pdf() for 1/Jacobian", q.wo, lobe.sample->wi, bsdf.pdf(q.wo, lobe.sample->wi),
                       lobe.share / area->value);
        c.known = area->error;
        c.one_sided = may_overlap(all, lobe);
        c.cause = "pdf() is {} times 1/Jacobian";
        if (c.one_sided && c.found > c.expected) c.error = 0;
        if (c.error > c.known + bound) c.known += rounding_of(bsdf.pdf, q.wo, lobe.sample->wi, epsilon);
        cases.push_back(c);
    }
    return cases;
}

bool fails(const std::vector<Case>& cases) {
    return std::ranges::any_of(cases, [](const Case& c) { return !(c.error <= c.known + bound); });
}

// A lobe that lies between two probes of u[0] takes of the share that its neighbour seems to have: where an answer
// fails, finer probes look for one. A few failures that remain are as good as all.
void ask_again(const BsdfSubject& bsdf, const Run& run, double epsilon, std::vector<std::vector<Case>>& answered) {
    constexpr int fine = 4096, enough = 8;
    int remain = 0;
    for (std::size_t i = 0; i < answered.size() && remain < enough; ++i) {
        if (!fails(answered[i])) continue;
        answered[i] = answers(bsdf, question(run, i, epsilon), epsilon, fine);
        for (Case& c : answered[i]) c.known += 1.0 / fine;
        if (fails(answered[i])) ++remain;
    }
}

}  // namespace

Verdict pdf_is_inverse_jacobian(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    constexpr std::size_t questions = 900;
    const double epsilon = epsilon_of(bsdf, traits, run);
    std::vector<std::vector<Case>> answered(questions);
    for_batches(questions, [&](std::size_t i) { answered[i] = answers(bsdf, question(run, i, epsilon), epsilon, 64); });
    ask_again(bsdf, run, epsilon, answered);
    std::vector<Case> cases;
    for (const auto& part : answered) cases.insert(cases.end(), part.begin(), part.end());
    return judged(cases, {.bound = bound,
                          .unit = "relative",
                          .coarse = 0.05,
                          .nothing = "no smooth lobe",
                          .factors = factors_of_densities()});
}

}  // namespace plumb::checks
