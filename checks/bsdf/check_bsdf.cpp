#include "checks/bsdf/check_bsdf.h"

#include <cmath>
#include <limits>
#include <ostream>

#include "checks/bsdf/lobes.h"
#include "checks/bsdf/sphere_grid.h"
#include "core/parallel.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"

namespace plumb::checks {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double quadrature_tolerance = 5e-5;
constexpr std::size_t quadrature_evaluations = 40'000;

std::array<double, 3> uniforms(RandomStream& random) {
    return {random.uniform(), random.uniform(), random.uniform()};
}

double relative_error(double found, double truth) {
    if (found == truth) return 0;
    return truth == 0 ? infinity : std::abs(found - truth) / std::abs(truth);
}

double relative_error(const Spectrum& found, const Spectrum& truth) {
    if (found == truth) return 0;
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, std::abs(found[i] - truth[i]));
    return is_finite(found) && largest(truth) > 0 ? worst / largest(truth) : infinity;
}

Verdict worst_of(const std::vector<BoundedCase>& cases, double bound, const std::string& unit,
                 const std::string& nothing) {
    return cases.empty() ? exactly(true, 0, nothing) : within_bound(cases, bound, unit);
}

// One list of cases a direction, in their order.
template <class PerDirection>
std::vector<BoundedCase> over_directions(const PerDirection& cases_at) {
    const std::vector<Vec3> directions = check_directions();
    std::vector<std::vector<BoundedCase>> parts(directions.size());
    for_batches(directions.size(), [&](std::size_t i) { parts[i] = cases_at(directions[i], i); });
    std::vector<BoundedCase> all;
    for (auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

Cubature over_sphere(const SphereGrid& grid, const std::function<double(Vec3)>& f) {
    return integrate([&](double polar, double azimuth) { return f(grid.direction(polar, azimuth)) * std::sin(polar); },
                     grid.rectangles(), quadrature_tolerance, quadrature_evaluations);
}

Cubature mass_of(const BsdfSubject& bsdf, Vec3 wo, const SphereGrid& grid) {
    return over_sphere(grid, [&](Vec3 wi) { return bsdf.pdf(wo, wi); });
}

// ---- sample() against pdf()

// The cells of one direction: runs of rectangles of some 1/24 of the mass each, then one for discrete samples and one
// for lost ones where they are not too rare; what is rarer than 1/40 joins the cell before it.
struct DirectionCells {
    Vec3 wo;
    SphereGrid grid;
    std::vector<std::size_t> cell_of_rectangle;
    std::size_t discrete_cell = 0, lost_cell = 0;
    std::vector<double> masses;
    double excess = 0;  // of the whole mass over 1

    [[nodiscard]] std::size_t cell(const std::optional<BsdfSample>& sample) const {
        if (!sample) return lost_cell;
        return sample->measure == Measure::discrete ? discrete_cell : cell_of_rectangle[grid.index(sample->wi)];
    }
};

constexpr double cell_mass = 1.0 / 24, least_mass = 1.0 / 40;

DirectionCells cells_at(const BsdfSubject& bsdf, const BsdfTraits& traits, Vec3 wo) {
    DirectionCells cells{wo, SphereGrid(wo, traits.roughness, traits.eta), {}, 0, 0, {}, 0};
    const Cubature mass = mass_of(bsdf, wo, cells.grid);
    const double discrete = bsdf.discrete ? bsdf.discrete(wo) : 0;
    double run = 0, rest = 1;
    const auto close_cell = [&] {
        cells.masses.push_back(run);
        rest -= run;
        run = 0;
    };
    const auto add = [&](double m) {  // to the open cell, which it closes when full
        const std::size_t cell = cells.masses.size();
        run += std::max(0.0, m);
        if (run >= cell_mass) close_cell();
        return cell;
    };
    for (const double m : mass.values) cells.cell_of_rectangle.push_back(add(m));
    if (run > least_mass) close_cell();
    cells.discrete_cell = cells.masses.size();
    run += discrete;
    if (run > least_mass) close_cell();
    cells.lost_cell = cells.masses.size();
    cells.excess = std::max(0.0, run - rest);
    run = std::max(0.0, rest);
    if (run > least_mass || cells.masses.empty())
        close_cell();
    else
        cells.masses.back() += run;
    for (std::size_t* cell : {&cells.discrete_cell, &cells.lost_cell}) *cell = std::min(*cell, cells.masses.size() - 1);
    for (std::size_t& cell : cells.cell_of_rectangle) cell = std::min(cell, cells.masses.size() - 1);
    return cells;
}

}  // namespace

Verdict samples_follow_pdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const std::vector<Vec3> directions = check_directions();
    std::vector<std::optional<DirectionCells>> tables(directions.size());
    for_batches(directions.size(), [&](std::size_t i) { tables[i] = cells_at(bsdf, traits, directions[i]); });
    DistributionClaim claim{{}, 0.04};
    std::vector<std::size_t> first;
    double total = 0;
    for (const auto& table : tables) {
        if (!(table->excess < 1e-3))
            return within_bound({{name_of(table->wo), table->excess}}, 1e-3, "of probability above 1");
        first.push_back(claim.probabilities.size());
        for (const double mass : table->masses) claim.probabilities.push_back(mass);
    }
    for (const double p : claim.probabilities) total += p;
    for (double& p : claim.probabilities) p /= total;
    const auto draw = [&](RandomStream& random) {
        const std::size_t i = random.below(directions.size());
        return first[i] + tables[i]->cell(bsdf.sample(directions[i], uniforms(random), Transport::importance));
    };
    Verdict verdict = distribution_is(draw, claim, run);
    for (auto& [name, value] : verdict.evidence) {
        if (name != "worst_cell") continue;
        const auto after = std::ranges::upper_bound(first, std::get<std::uint64_t>(value));
        verdict.reason +=
            fmt::format(", wo {}", name_of(directions[static_cast<std::size_t>(after - first.begin()) - 1]));
    }
    return verdict;
}

// ---- pdf() against sample()'s Jacobian

namespace {

// |∂wi/∂u1 × ∂wi/∂u2| by central differences of fourth order; empty where the lobe does not reach that far.
std::optional<double> jacobian(const BsdfSubject& bsdf, Vec3 wo, const Lobe& lobe, const std::array<double, 2>& u) {
    constexpr double h = 1e-5;
    std::array<Vec3, 2> derivative;
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (const auto& [steps, factor] : {std::pair{1, 8.0}, {-1, -8.0}, {2, -1.0}, {-2, 1.0}}) {
            std::array<double, 3> v{lobe.middle(), u[0], u[1]};
            v[axis + 1] += steps * h;
            const std::optional<BsdfSample> there = bsdf.sample(wo, v, Transport::importance);
            if (!same_lobe(there, lobe.sample)) return {};
            derivative[axis] += (there->wi - lobe.sample->wi) * (factor / (12 * h));
        }
    return length(cross(derivative[0], derivative[1]));
}

// Whether two smooth lobes of wo end on that side of the surface, for any of the u at which its lobes were found.
bool overlap(const std::vector<std::vector<Lobe>>& lobes_at, double side) {
    return std::ranges::any_of(lobes_at, [&](const std::vector<Lobe>& all) {
        return std::ranges::count_if(
                   all, [&](const Lobe& lobe) { return lobe.smooth() && lobe.sample->wi.z * side > 0; }) > 1;
    });
}

constexpr std::size_t jacobian_points = 36;

// Spread by the powers of the plastic number [Roberts 2018], off the diagonals that maps from squares to disks fold at.
std::array<double, 2> jacobian_point(std::size_t i) {
    const auto spread = [&](double step) {
        return 0.03 + 0.94 * std::fmod(0.5 + step * static_cast<double>(i + 1), 1);
    };
    return {spread(0.75487766624669276), spread(0.56984029099805327)};
}

}  // namespace

Verdict pdf_is_inverse_jacobian(const BsdfSubject& bsdf) {
    const auto cases = over_directions([&](Vec3 wo, std::size_t) {
        std::vector<std::vector<Lobe>> lobes_at;
        for (std::size_t i = 0; i < jacobian_points; ++i)
            lobes_at.push_back(lobes(bsdf, wo, jacobian_point(i), Transport::importance));
        const bool mixed_above = overlap(lobes_at, 1), mixed_below = overlap(lobes_at, -1);
        std::vector<BoundedCase> errors;
        for (std::size_t i = 0; i < jacobian_points; ++i)
            for (const Lobe& lobe : lobes_at[i]) {
                const auto area = lobe.smooth() ? jacobian(bsdf, wo, lobe, jacobian_point(i)) : std::nullopt;
                if (!area) continue;
                const double ratio = bsdf.pdf(wo, lobe.sample->wi) * *area / lobe.share();
                const bool mixed = lobe.sample->wi.z > 0 ? mixed_above : mixed_below;
                errors.push_back(
                    {fmt::format("{}, u = ({:.3f}, {:.3f})", name_of(wo), jacobian_point(i)[0], jacobian_point(i)[1]),
                     mixed ? std::max(0.0, 1 - ratio) : std::abs(1 - ratio), std::abs(wo.z)});
            }
        return errors;
    });
    return worst_of(cases, 1e-5, "relative", "no smooth lobe");
}

Verdict weight_is_eval_over_pdf(const BsdfSubject& bsdf, const Run& run) {
    const auto cases = over_directions([&](Vec3 wo, std::size_t i) {
        std::vector<BoundedCase> errors;
        RandomStream random = run.random(i);
        for (int k = 0; k < 128; ++k) {
            const Transport transport = k % 2 ? Transport::radiance : Transport::importance;
            const std::optional<BsdfSample> sample = bsdf.sample(wo, uniforms(random), transport);
            if (!sample || sample->measure == Measure::discrete) continue;
            const double density = bsdf.pdf(wo, sample->wi);
            errors.push_back({name_of(wo) + ", pdf", relative_error(sample->pdf, density)});
            errors.push_back({name_of(wo) + ", weight",
                              relative_error(sample->weight * density, bsdf.eval(wo, sample->wi, transport))});
        }
        double discrete = 0;
        for (const Lobe& lobe : lobes(bsdf, wo, {0.37, 0.61}, Transport::importance))
            if (lobe.discrete()) {
                errors.push_back({name_of(wo) + ", share", std::abs(lobe.sample->pdf - lobe.share())});
                discrete += lobe.share();
            }
        if (bsdf.discrete) errors.push_back({name_of(wo) + ", discrete", std::abs(bsdf.discrete(wo) - discrete)});
        return errors;
    });
    return worst_of(cases, 1e-7, "relative", "nothing scatters");
}

Verdict masses_match(const BsdfSubject& bsdf, const BsdfTraits& traits) {
    // Kronecker's lattice: the roots of x² = x + 1 for the lobe, of x³ = x + 1 for the direction
    constexpr std::array<double, 3> step{0.61803398874989485, 0.75487766624669276, 0.56984029099805327};
    constexpr std::uint64_t points = 1 << 15;
    const auto cases = over_directions([&](Vec3 wo, std::size_t index) {
        if (index % 3 != 0 && std::abs(wo.z) > 0.1) return std::vector<BoundedCase>{};
        std::uint64_t smooth = 0, discrete = 0;
        for (std::uint64_t k = 0; k < points; ++k) {
            std::array<double, 3> u;
            for (std::size_t axis = 0; axis < 3; ++axis)
                u[axis] = std::fmod(0.5 + static_cast<double>(k) * step[axis], 1);
            if (const auto sample = bsdf.sample(wo, u, Transport::importance))
                ++(sample->measure == Measure::discrete ? discrete : smooth);
        }
        const Cubature mass = mass_of(bsdf, wo, SphereGrid(wo, traits.roughness, traits.eta));
        std::vector<BoundedCase> errors{
            {name_of(wo) + ", smooth", std::abs(mass.total - static_cast<double>(smooth) / points) + mass.error}};
        if (bsdf.discrete)
            errors.push_back(
                {name_of(wo) + ", discrete", std::abs(bsdf.discrete(wo) - static_cast<double>(discrete) / points)});
        return errors;
    });
    return within_bound(cases, 4e-3, "of probability");  // the lattice resolves 1e-3, the quadrature likewise
}

Verdict is_reciprocal(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const auto cases = over_directions([&](Vec3 wo, std::size_t i) {
        std::vector<BoundedCase> errors;
        RandomStream random = run.random(i);
        for (int k = 0; k < 64; ++k) {
            const auto sample = bsdf.sample(wo, uniforms(random), Transport::importance);
            if (!sample || sample->measure == Measure::discrete) continue;
            const Vec3 wi = sample->wi;
            const auto f = [&](Vec3 from, Vec3 to, Transport t) { return bsdf.eval(from, to, t) / std::abs(to.z); };
            const Spectrum back = f(wi, wo, Transport::radiance);
            const double across = same_side(wo, wi) ? 1 : wo.z > 0 ? traits.eta : 1 / traits.eta;
            errors.push_back({name_of(wo) + ", adjoint", relative_error(f(wo, wi, Transport::importance), back)});
            errors.push_back(
                {name_of(wo) + ", f/eta²", relative_error(f(wo, wi, Transport::radiance) * (across * across), back)});
        }
        return errors;
    });
    return worst_of(cases, 1e-7, "relative", "no smooth lobe");
}

Verdict radiance_scales_by_eta_squared(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const auto cases = over_directions([&](Vec3 wo, std::size_t i) {
        std::vector<BoundedCase> errors;
        RandomStream random = run.random(i);
        for (int k = 0; k < 64; ++k) {
            const std::array<double, 3> u = uniforms(random);
            const auto particle = bsdf.sample(wo, u, Transport::importance);
            const auto light = bsdf.sample(wo, u, Transport::radiance);
            if (!particle && !light) continue;
            const bool both = particle && light;
            const double across = !both || same_side(wo, light->wi) ? 1 : wo.z > 0 ? traits.eta : 1 / traits.eta;
            errors.push_back({name_of(wo), both ? relative_error(light->weight * (across * across), particle->weight) +
                                                      std::abs(light->eta - across)
                                                : infinity});
        }
        return errors;
    });
    return worst_of(cases, 1e-14, "relative", "nothing scatters");
}

Verdict conserves_energy(const BsdfSubject& bsdf, const BsdfTraits& traits, double tolerance) {
    const auto cases = over_directions([&](Vec3 wo, std::size_t) {
        const auto smooth = over_sphere(SphereGrid(wo, traits.roughness, traits.eta),
                                        [&](Vec3 wi) { return largest(bsdf.eval(wo, wi, Transport::importance)); });
        double albedo = smooth.total;
        for (const Lobe& lobe : lobes(bsdf, wo, {0.37, 0.61}, Transport::importance))
            if (lobe.discrete()) albedo += lobe.share() * largest(lobe.sample->weight);
        const bool exact = traits.lossless && wo.z > 0;
        const double error = exact ? std::abs(albedo - 1) : std::max(0.0, albedo - 1);
        return std::vector<BoundedCase>{{fmt::format("{}, albedo {:.6f}", name_of(wo), albedo), error + smooth.error}};
    });
    return within_bound(cases, tolerance, "of the light");
}

std::ostream& operator<<(std::ostream& out, const NamedVerdict& named) {
    return out << named.property << ": " << named.verdict;
}

std::vector<NamedVerdict> check_bsdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const std::vector<std::pair<std::string, std::function<Verdict()>>> others{
        {"sample", [&] { return samples_follow_pdf(bsdf, traits, run); }},
        {"pdf", [&] { return pdf_is_inverse_jacobian(bsdf); }},
        {"weight", [&] { return weight_is_eval_over_pdf(bsdf, run.part("weight")); }},
        {"mass", [&] { return masses_match(bsdf, traits); }},
        {"reciprocity", [&] { return is_reciprocal(bsdf, traits, run.part("reciprocity")); }},
        {"eta-squared", [&] { return radiance_scales_by_eta_squared(bsdf, traits, run.part("eta-squared")); }},
        {"energy", [&] { return conserves_energy(bsdf, traits); }}};
    std::vector<NamedVerdict> all{{"values", values_are_sound(bsdf, run.part("values"))}};
    const bool sound = all[0].verdict.outcome != Outcome::refuted;
    for (const auto& [property, check] : others) {
        Verdict verdict;
        verdict.reason = "not tried, because the values are refuted";
        all.push_back({property, sound ? check() : verdict});
    }
    return all;
}

}  // namespace plumb::checks
