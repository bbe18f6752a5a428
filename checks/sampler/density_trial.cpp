#include "checks/sampler/density_trial.h"

#include <fmt/format.h>

#include <cmath>

#include "checks/sampler/lines.h"
#include "checks/sampler/uniformity.h"
#include "core/error.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/distributions.h"

namespace plumb::checks {
namespace {

constexpr double default_delta = 0.05;
// Of alpha; they sum to 1. Chi-square is what `holds` rests on.
constexpr double of_chi_square = 0.5, of_evenness = 0.1, of_cumulative = 0.2, of_dyadic = 0.2;
constexpr double printed_precision = 1e-4;  // of a density in a line: half of what five digits can lose

struct Answer {
    std::vector<std::uint64_t> counts;  // one a cell; the last: outside of them all
    std::string outside, wrong_pdf;     // what was first wrong, in words
    std::uint64_t lines = 0, outside_line = 0, wrong_pdfs = 0;
    Uniformity uniformity;  // of cumulative probabilities
};

void note_pdf(Answer& answer, const CellDensity& density, const Point<2>& point, double printed,
              std::string_view line) {
    if (!density.pdf) return;
    const double pdf = density.pdf(point);
    if (std::abs(printed - pdf) <= printed_precision * pdf) return;
    if (answer.wrong_pdfs++ == 0)
        answer.wrong_pdf = fmt::format("line {}, '{}', where it is {:.6g}", answer.lines, line.substr(0, 60), pdf);
}

Answer ask(const std::string& command, const SamplerTrial& trial, const CellDensity& density, std::uint64_t n) {
    Answer answer;
    answer.counts.resize(density.cells.size() + 1);
    const auto axes = static_cast<std::size_t>(density.dimension);
    const auto use = [&](std::span<const double> numbers, std::string_view line, std::uint64_t number) {
        answer.lines = number;
        const Point<2> point{numbers[0], axes == 2 ? numbers[1] : 0};
        const std::size_t cell = density.cell_of(point);
        ++answer.counts[cell];
        const bool outside = cell == density.cells.size() || density.cells[cell].probability == 0;
        if (answer.outside_line == 0 && outside) {
            answer.outside_line = number;
            answer.outside = line;
        }
        if (outside) return;
        if (density.cumulative) answer.uniformity.add(density.cumulative(point[0]));
        if (numbers.size() > axes) note_pdf(answer, density, point, numbers.back(), line);
    };
    for_lines(command, trial, n, axes, axes + (density.pdf ? 1 : 0), axes == 1 ? "a number, x" : "two numbers, x,y",
              use);
    return answer;
}

std::string words(const CellDensity::Cell& cell, int dimension) {
    const std::string x = fmt::format("[{:.6g}, {:.6g})", cell.x.low, cell.x.high);
    return dimension == 1 ? x : fmt::format("{} x [{:.6g}, {:.6g})", x, cell.y.low, cell.y.high);
}

// Where the cumulative function reaches u.
double quantile(const CellDensity& density, double u) {
    double low = density.cells.front().x.low, high = density.cells.front().x.high;
    for (const CellDensity::Cell& cell : density.cells) {
        low = std::min(low, cell.x.low);
        high = std::max(high, cell.x.high);
    }
    if (u <= 0) return low;
    for (int i = 0; i < 60; ++i) {
        const double middle = low + (high - low) / 2;
        (density.cumulative(middle) < u ? low : high) = middle;
    }
    return high;
}

void refute(Verdict& verdict, double p_value, std::string reason) {
    verdict.outcome = Outcome::refuted;
    verdict.p_value = p_value;
    verdict.reason = std::move(reason);
}

// What cells do not see: where in them samples lie, and whether they are as uneven as chance.
void look_closer(Verdict& verdict, const CellDensity& density, const Answer& answer, double alpha) {
    const double freedom = std::get<double>(verdict.evidence.front().second);
    if (const double p = chi_square_lower_tail(verdict.statistic, freedom); p < of_evenness * alpha)
        return refute(verdict, p,
                      fmt::format("more even than chance: chi-square {:.4g} at {:g} degrees of freedom (p = {:.1e}); "
                                  "stratified and quasi-random sequences are not independent samples",
                                  verdict.statistic, freedom, p));
    if (!density.cumulative) return;
    if (const Unevenness worst = answer.uniformity.dyadic(); worst.p_value < of_dyadic * alpha)
        return refute(verdict, worst.p_value,
                      fmt::format("[{:.6g}, {:.6g}), of probability {:.4g}: found {:.4g} (p ≤ {:.1e})",
                                  quantile(density, worst.low), quantile(density, worst.high), worst.high - worst.low,
                                  worst.found, worst.p_value));
    if (const Unevenness worst = answer.uniformity.cumulative(); worst.p_value < of_cumulative * alpha)
        return refute(verdict, worst.p_value,
                      fmt::format("below {:.6g}, of probability {:.4g}: found {:.4g} (Kolmogorov–Smirnov, p ≤ {:.1e})",
                                  quantile(density, worst.high), worst.high, worst.found, worst.p_value));
}

std::string where_it_looked(const CellDensity& density) {
    const std::string cells = fmt::format("looked in {} cells", density.cells.size());
    if (!density.cumulative) return cells + ", and nowhere within them";
    return cells + ", in halves, quarters … 4096ths of the probability, and at the cumulative one (Kolmogorov–Smirnov)";
}

// The engine speaks of cells by number; whoever wrote the sampler thinks in x.
void name_worst_cell(Verdict& verdict, const CellDensity& density, const Answer& answer) {
    for (const auto& [name, value] : std::vector<Field>(verdict.evidence)) {
        if (name != "worst_cell") continue;
        const std::size_t worst = std::get<std::uint64_t>(value);
        const double found = static_cast<double>(answer.counts[worst]) / static_cast<double>(answer.lines);
        const std::string cell = words(density.cells[worst], density.dimension);
        verdict.evidence.emplace_back("worst_cell_is", cell);
        if (verdict.outcome == Outcome::refuted)
            verdict.reason +=
                fmt::format(", {}, of probability {:.4g}: found {:.4g}", cell, density.cells[worst].probability, found);
    }
}

Verdict judge(const CellDensity& density, const Answer& answer, const DistributionClaim& claim, const Run& run) {
    Verdict verdict = chi_square_verdict(answer.counts, claim, of_chi_square * run.alpha(), run.beta());
    if (answer.outside_line > 0) {
        std::uint64_t outside = answer.counts.back();
        for (std::size_t i = 0; i < density.cells.size(); ++i)
            if (density.cells[i].probability == 0) outside += answer.counts[i];
        refute(verdict, 0,
               fmt::format("{} of {} samples fell where the density is zero, first line {}: '{}'", outside,
                           answer.lines, answer.outside_line, answer.outside));
        return verdict;
    }
    name_worst_cell(verdict, density, answer);
    if (answer.wrong_pdfs > 0)
        refute(verdict, 0,
               fmt::format("{} of {} printed densities are wrong, first {}", answer.wrong_pdfs, answer.lines,
                           answer.wrong_pdf));
    if (verdict.outcome != Outcome::refuted) look_closer(verdict, density, answer, run.alpha());
    verdict.reason += "; " + where_it_looked(density);
    verdict.evidence.emplace_back("looked", where_it_looked(density));
    return verdict;
}

}  // namespace

void add_density(Catalogue& catalogue, const SamplerTrial& trial, CellDensity density, std::uint64_t seed,
                 double alpha) {
    const ErrorTarget delta = trial.delta.value_or(ErrorTarget{default_delta, false});
    DistributionClaim claim{.probabilities = {}, .delta = delta.error};
    for (const CellDensity::Cell& cell : density.cells) claim.probabilities.push_back(cell.probability);

    const Run run(seed, "sampler/density", alpha);
    const std::uint64_t n = distribution_samples(claim, of_chi_square * run.alpha(), run.beta());
    if (n > trial.most_samples)
        throw Error(
            fmt::format("delta {:g} and the rarest cell of '{}' ask for {} samples; accepted: at most {}; a larger "
                        "delta or likelier cells need fewer",
                        delta.error, density.name, n, trial.most_samples));
    const std::string command = command_for(trial, seed, n);
    const Answer answer = ask(command, trial, density, n);
    catalogue.add(
        {.id = "sampler/density",
         .statement = fmt::format("`{}` draws from the density {}{}.", trial.command, density.name, density.remark),
         .source = fmt::format("the command line: --sampler, --density {}", trial.density),
         .kind = Kind::distribution,
         .trial =
             [=](const Run& judging) {
                 Verdict verdict = judge(density, answer, claim, judging);
                 verdict.evidence.emplace_back("command", command);
                 return verdict;
             },
         .no_mutant = "the sampler is another program: a defect is its author's to plant"});
}

}  // namespace plumb::checks
