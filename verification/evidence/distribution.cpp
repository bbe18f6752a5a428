#include "verification/evidence/distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/error.h"
#include "core/parallel.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/independence.h"

namespace plumb {
namespace {

constexpr double undecided_risk = 1e-5;
constexpr std::uint64_t most_samples = std::uint64_t{1} << 32;

int positive_cells(const DistributionClaim& claim) {
    return static_cast<int>(std::ranges::count_if(claim.probabilities, [](double q) { return q > 0; }));
}

void check_setting(const DistributionClaim& claim) {
    const double total = std::accumulate(claim.probabilities.begin(), claim.probabilities.end(), 0.0);
    if (!(std::abs(total - 1) <= 1e-9))
        throw std::logic_error(fmt::format("distribution_is: the probabilities sum to {:.17g}, not 1", total));
    if (std::ranges::any_of(claim.probabilities, [](double q) { return !(q >= 0); }))
        throw std::logic_error("distribution_is: a probability is negative or NaN");
    if (positive_cells(claim) < 2) throw std::logic_error("distribution_is: fewer than two cells have probability");
    if (!claim.errors.empty() && claim.errors.size() != claim.probabilities.size())
        throw std::logic_error("distribution_is: there are not as many errors as probabilities");
    if (!(claim.delta > 0)) throw std::logic_error("distribution_is: delta must be positive");
}

double rarest_cell(const DistributionClaim& claim) {
    double rarest = 1;
    for (const double q : claim.probabilities)
        if (q > 0) rarest = std::min(rarest, q);
    return rarest;
}

double error_of(const DistributionClaim& claim, std::size_t cell) {
    return cell < claim.errors.size() ? claim.errors[cell] : 0;
}

// The phi that the errors of the probabilities may amount to.
double known_phi(const DistributionClaim& claim) {
    double sum = 0;
    for (std::size_t cell = 0; cell < claim.errors.size(); ++cell)
        if (const double q = claim.probabilities[cell]; q > 0) sum += claim.errors[cell] * claim.errors[cell] / q;
    return std::sqrt(sum);
}

// A density error of delta may sit in one cell, whose count then varies as p and not as q: along the error the variance
// is at most s² = 1 + delta/sqrt(q_min) times the noncentral chi-square's. A bound at s quantiles makes up for it;
// where that tail is too small for the noncentral chi-square, one coordinate is as short as the whole vector or
// shorter.
double noncentrality_bound(double chi_square, const DistributionClaim& claim, double beta) {
    const double z = std::sqrt(1 + claim.delta / std::sqrt(rarest_cell(claim))) * normal_upper_quantile(beta);
    if (z > 6) return std::pow(std::sqrt(chi_square) + z, 2);
    return noncentrality_upper_bound(chi_square, positive_cells(claim) - 1, normal_two_sided_tail(z) / 2);
}

// Under the claim every set of counts has about the probability of a unit cube in the space of counts, and such a cube
// reaches half its diagonal beyond its middle: P(X² ≤ x) is at most that of a ball so much larger. Counts on a grid of
// their own (two cells: X² = 0 at every other n) are no evidence then.
double evenness_p_value(double chi_square, double n, const DistributionClaim& claim) {
    double diagonal = 0;
    for (const double q : claim.probabilities)
        if (q > 0) diagonal += 1 / (n * q);
    const double radius = std::sqrt(chi_square) + std::sqrt(diagonal) / 2;
    return chi_square_lower_tail(radius * radius, positive_cells(claim) - 1);
}

// Cells in the order of their numbers: what is near in the sample space is mostly near there.
std::string memory_of(const DrawCell& draw, const std::vector<double>& first, const Run& run) {
    const auto cell = [&](RandomStream& random) { return static_cast<double>(draw(random)); };
    if (std::string state = complaint_of_state(cell, first, run); !state.empty()) return state;
    Independence independence;
    independence.add(first);
    return independence.complaint();
}

}  // namespace

// The upper tail of one rare cell is exp(z³/(6 sqrt(E))) times the normal one, the lower one its inverse: at
// E = (z³/4)² their mean exceeds the level by 1.24, counted exactly for levels from 1e-8 to 1e-2.
double least_expected_count(double alpha) {
    return std::max(100.0, std::pow(normal_upper_quantile(alpha / 2), 6) / 16);
}

std::uint64_t distribution_samples(const DistributionClaim& claim, double alpha, double beta) {
    const double freedom = positive_cells(claim) - 1;
    const double unlucky = chi_square_upper_quantile(undecided_risk, freedom);
    // what is known about q adds to the bound of phi, and to phi itself; beyond delta/4 more samples would not help
    const double room = claim.delta - 2 * std::min(known_phi(claim), claim.delta / 4);
    const double by_power = noncentrality_bound(unlucky, claim, beta) / (room * room);
    const double by_count = least_expected_count(alpha) / rarest_cell(claim);
    const double needed = std::ceil(std::max(by_power * (1 + 1e-6), by_count));
    return static_cast<std::uint64_t>(std::min(needed, 0x1p63));
}

std::size_t equal_cell(double u, std::size_t cells) {
    if (!(u >= 0 && u < 1)) return cells;  // outside: where the density is zero
    return std::min(cells - 1, static_cast<std::size_t>(u * static_cast<double>(cells)));
}

Verdict chi_square_verdict(std::span<const std::uint64_t> counts, const DistributionClaim& claim, double alpha,
                           double beta, int degrees_of_freedom) {
    const double n = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    const double freedom = degrees_of_freedom < 0 ? positive_cells(claim) - 1 : degrees_of_freedom;
    Verdict verdict;
    verdict.samples = static_cast<std::uint64_t>(n);
    verdict.resolution = claim.delta;
    double chi_square = 0, at_best = 0, worst = 0;  // at_best: with the nearest probabilities that errors allow
    std::size_t worst_cell = 0;
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        const double q = cell < claim.probabilities.size() ? claim.probabilities[cell] : 0;
        const double observed = static_cast<double>(counts[cell]);
        if (q == 0 && observed > 0) {
            verdict.outcome = Outcome::refuted;
            verdict.p_value = 0;
            verdict.reason = fmt::format("{} of {} samples fell into cell {}, where the density is zero", counts[cell],
                                         verdict.samples, cell);
            return verdict;
        }
        if (q == 0) continue;
        const double nearest = std::clamp(observed / n, q - error_of(claim, cell), q + error_of(claim, cell));
        const double z = (observed - n * nearest) / std::sqrt(n * nearest);
        at_best += observed == n * nearest ? 0 : z * z;
        const double as_stated = (observed - n * q) / std::sqrt(n * q);
        chi_square += as_stated * as_stated;
        if (std::abs(z) > std::abs(worst)) {
            worst = z;
            worst_cell = cell;
        }
    }
    verdict.statistic = at_best;
    verdict.p_value = chi_square_tail(at_best, freedom);
    const double phi_bound = std::sqrt(noncentrality_bound(chi_square, claim, beta) / n) + known_phi(claim);
    verdict.deviation = {0, phi_bound};
    verdict.evidence = {
        {"degrees_of_freedom", freedom}, {"phi_upper_bound", phi_bound},
        {"delta", claim.delta},          {"worst_cell", static_cast<std::uint64_t>(worst_cell)},
        {"worst_cell_z", worst},         {"cells", static_cast<std::uint64_t>(claim.probabilities.size())}};
    if (evenness_p_value(chi_square, n, claim) < std::min(alpha, 1e-6)) {
        verdict.reason = fmt::format(
            "draws are not independent: chi-square {:.3g} at {:g} degrees of freedom is more even than chance, as of a "
            "stratified or quasi-random sequence",
            chi_square, freedom);
    } else if (verdict.p_value < alpha) {
        verdict.outcome = Outcome::refuted;
        verdict.reason =
            fmt::format("chi-square {:.4g} at {:g} degrees of freedom (p = {:.1e}); worst cell {}: {:+.1f} sigma",
                        at_best, freedom, verdict.p_value, worst_cell, worst);
    } else if (phi_bound < claim.delta) {
        verdict.outcome = Outcome::holds;
        verdict.reason =
            fmt::format("chi-square {:.4g} at {:g} degrees of freedom: a density error phi of {:.2g} is excluded",
                        chi_square, freedom, claim.delta);
    } else {
        verdict.reason =
            fmt::format("a density error phi up to {:.2g} could hide; claimed: below {:.2g}", phi_bound, claim.delta);
    }
    return verdict;
}

Verdict distribution_is(const DrawCell& draw, const DistributionClaim& claim, const Run& run) {
    check_setting(claim);
    constexpr std::uint64_t batch = 4096;
    const std::uint64_t n = distribution_samples(claim, run.alpha(), run.beta());
    if (n > most_samples)
        throw Error(
            fmt::format("distribution: {} samples are needed (rarest cell {:.2g}, delta {:.2g}); join rare cells with "
                        "their neighbours or allow a larger delta",
                        n, rarest_cell(claim), claim.delta));
    const std::uint64_t batches = (n + batch - 1) / batch;
    const std::size_t cells = claim.probabilities.size();
    std::vector<std::vector<std::uint64_t>> partial(batches);
    std::vector<double> first(std::min<std::uint64_t>(n, Independence::most_ranked));
    for_batches(batches, [&](std::size_t b) {
        std::vector<std::uint64_t> counts(cells + 1);  // the last: outside every cell
        for (std::uint64_t i = b * batch; i < std::min<std::uint64_t>((b + 1) * batch, n); ++i) {
            RandomStream random = run.random(i);
            const std::size_t cell = std::min(draw(random), cells);
            ++counts[cell];
            if (i < first.size()) first[i] = static_cast<double>(cell);
        }
        partial[b] = std::move(counts);
    });
    std::vector<std::uint64_t> counts(cells + 1);
    for (const auto& part : partial)
        for (std::size_t cell = 0; cell <= cells; ++cell) counts[cell] += part[cell];
    Verdict verdict = chi_square_verdict(counts, claim, run.alpha(), run.beta());
    if (const std::string memory = memory_of(draw, first, run); !memory.empty() && counts.back() == 0) {
        verdict.outcome = Outcome::undecided;
        verdict.reason = memory;
    }
    return verdict;
}

}  // namespace plumb
