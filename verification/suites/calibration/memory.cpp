// The watch for draws with a memory on trial: what it must see, and what it must not take for one.

#include <cmath>

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/independence.h"
#include "verification/evidence/mean.h"
#include "verification/suites/calibration/laws.h"
#include "verification/suites/tally.h"

namespace plumb::suites {
namespace {

using Values = std::function<std::vector<double>(RandomStream&)>;

// Whether the watch complains of the values. Wrapped, as a subject is judged and judges nothing.
struct Watch {
    std::function<bool(std::span<const double>)> complains;
};

bool as_shipped(std::span<const double> values) {
    Independence independence;
    independence.add(values);
    return !independence.complaint().empty();
}

bool never(std::span<const double>) {
    return false;
}

// The correlation of neighbours itself, taken for normal whatever the values: two spikes side by side exceed any bound.
bool by_values(std::span<const double> values) {
    const Moments moments = Moments::of(values);
    double sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        sum += (values[i] - moments.mean()) * (values[i - 1] - moments.mean());
    return std::abs(sum) > 5.33 * moments.variance() * std::sqrt(static_cast<double>(values.size()));
}

// Each the last times rho and something new; normal, of variance 1.
Values correlated(double rho, std::size_t count) {
    return [=, law = normal()](RandomStream& random) {
        std::vector<double> values(count);
        double last = law.draw(0, random).x;
        for (double& x : values) x = last = rho * last + std::sqrt(1 - rho * rho) * law.draw(0, random).x;
        return values;
    };
}

// From a list of so many values, each as likely as the next or one after the other.
Values listed(std::size_t different, std::size_t count, bool in_turn) {
    return [=](RandomStream& random) {
        std::vector<double> list(different), values(count);
        for (double& x : list) x = random.uniform();
        for (std::size_t i = 0; i < count; ++i) values[i] = list[in_turn ? i % different : random.below(different)];
        return values;
    };
}

// Laws whose values repeat, lie on a grid or have no variance, by their nature; independent.
std::vector<double> honest(std::uint64_t law, RandomStream& random) {
    std::vector<double> values(8192);
    for (double& x : values) {
        const double u = random.uniform();
        x = law == 0   ? std::floor(6 * u)
            : law == 1 ? 0.01 * std::floor(1000 * u)
            : law == 2 ? static_cast<double>(static_cast<float>(std::floor(1024 * u) / 1023))
                       : std::pow(1 - u, -2.0);
    }
    return values;
}

Verdict honest_laws_pass(const Watch& watch, const Run& run) {
    Tally tally;
    for (std::uint64_t i = 0; i < run.pick(16u, 256u); ++i) {
        RandomStream random = run.random(i);
        tally.expect(!watch.complains(honest(i % 4, random)), [&] { return fmt::format("law {} is refused", i % 4); });
    }
    return tally.verdict("runs of independent values are let through");
}

bool by_any_repetition(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) != sorted.end();
}

// One value in 300 is 1, the others are 0: two in a row come by chance in one run in sixty.
Verdict complains_of_rare_values(const Watch& watch, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        std::vector<double> values(2000);
        for (double& x : values) x = random.uniform() < 1.0 / 300 ? 1 : 0;
        return watch.complains(values) ? 1.0 : 0.0;
    };
    const auto cap = run.pick<std::uint64_t>(8192, 1 << 17);
    return mean_at_most(draw, {.bound = 0.005, .margin = 0.0025, .bounds = {0, 1}, .cap = cap}, run);
}

// A memory so plain that no run misses it.
void add_seen(Catalogue& catalogue, std::string id, std::string statement, const Values& values) {
    const auto check = [values](const Watch& watch, const Run& run) {
        Tally tally;
        for (std::uint64_t i = 0; i < 32; ++i) {
            RandomStream random = run.random(i);
            const std::vector<double> drawn = values(random);
            tally.expect(watch.complains(drawn), [&] { return fmt::format("run {} is taken for independent", i); });
        }
        return tally.verdict("runs are seen to have a memory");
    };
    catalogue.add({.id = "calibration/memory/" + id,
                   .statement = std::move(statement),
                   .source = "docs/statistics.md, Draws with a memory",
                   .kind = Kind::exact,
                   .trial = {check, Watch{as_shipped}, {{"no-watch", "Nothing looks for it.", Watch{never}}}}});
}

// ---- more even than chance ----

using CellsVerdict = Outcome (*)(const std::vector<std::uint64_t>& counts, const DistributionClaim& claim);

Outcome chi_square(const std::vector<std::uint64_t>& counts, const DistributionClaim& claim) {
    return chi_square_verdict(counts, claim, alpha_in_use, beta_in_use).outcome;
}
Outcome chi_square_alone(const std::vector<std::uint64_t>& counts, const DistributionClaim& claim) {
    double n = 0, sum = 0;
    for (const std::uint64_t count : counts) n += static_cast<double>(count);
    for (std::size_t i = 0; i < counts.size(); ++i)
        sum += std::pow(static_cast<double>(counts[i]) - n * claim.probabilities[i], 2) / (n * claim.probabilities[i]);
    const double freedom = static_cast<double>(counts.size() - 1);
    return chi_square_tail(sum, freedom) < alpha_in_use                                          ? Outcome::refuted
           : noncentrality_upper_bound(sum, freedom, beta_in_use) < n * std::pow(claim.delta, 2) ? Outcome::holds
                                                                                                 : Outcome::undecided;
}

struct Cells {
    CellsVerdict verdict;
};

// Multiples of an irrational number, modulo 1, in equal cells.
Verdict even_counts_are_undecided(const Cells& subject) {
    Tally tally;
    for (const double step : {(std::sqrt(5.0) - 1) / 2, std::sqrt(2.0) - 1, std::sqrt(3.0) - 1})
        for (const std::size_t cells : {16u, 64u, 256u}) {
            const DistributionClaim claim{std::vector<double>(cells, 1 / static_cast<double>(cells)), 0.05};
            const std::uint64_t n = distribution_samples(claim, alpha_in_use, beta_in_use);
            std::vector<std::uint64_t> counts(cells);
            for (std::uint64_t i = 0; i < n; ++i) {
                const double x = step * static_cast<double>(i);
                ++counts[equal_cell(x - std::floor(x), cells)];
            }
            const Outcome outcome = subject.verdict(counts, claim);
            tally.expect(outcome == Outcome::undecided,
                         [&] { return fmt::format("step {:.4f} in {} cells: {}", step, cells, to_string(outcome)); });
        }
    return tally.verdict("sequences that are more even than chance are undecided");
}

}  // namespace

void add_calibration_memory(Catalogue& catalogue) {
    add_seen(catalogue, "correlated", "A correlation of 0.6 from each draw to the next is seen in 1600 draws.",
             correlated(0.6, 1600));
    add_seen(catalogue, "alternating", "A correlation of -0.3 from each draw to the next is seen in 1600 draws.",
             correlated(-0.3, 1600));
    add_seen(catalogue, "few-seeds", "A generator of 1,024 seeds is seen in 8,192 draws.", listed(1024, 8192, false));
    add_seen(catalogue, "short-period", "A period of 1,000 is seen in 8,192 draws.", listed(1000, 8192, true));
    catalogue.add(
        {.id = "calibration/memory/rare",
         .statement = "Independent values of which one in 300 differs are complained of in at most 0.5 % of the "
                      "runs of 2000.",
         .source = "docs/statistics.md, Draws with a memory",
         .kind = Kind::mean,
         .trial = {complains_of_rare_values,
                   Watch{as_shipped},
                   {{"by-values", "The correlation of the values themselves is taken for normal.", Watch{by_values}}}},
         .sizes = Sizes::full_only});
    catalogue.add({.id = "calibration/memory/honest",
                   .statement = "Independent values of a die, on a grid, in single precision or without a mean are let "
                                "through.",
                   .source = "docs/statistics.md, Draws with a memory",
                   .kind = Kind::exact,
                   .trial = {honest_laws_pass,
                             Watch{as_shipped},
                             {{"any-repetition", "Whatever repeats is refused.", Watch{by_any_repetition}}}}});
    catalogue.add(
        {.id = "calibration/memory/even",
         .statement = "Multiples of the golden ratio, of √2 and √3 modulo 1 in 16 to 256 cells are no sample of "
                      "independent values: undecided.",
         .source = "docs/statistics.md, Draws with a memory",
         .kind = Kind::exact,
         .trial = {even_counts_are_undecided,
                   Cells{chi_square},
                   {{"upper-tail-alone", "Only the chi-square's upper tail is looked at.", Cells{chi_square_alone}}}}});
}

}  // namespace plumb::suites
