#include "checks/sampler/sampler.h"

#include <fmt/format.h>

#include "checks/sampler/cell_density.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/process.h"
#include "verification/evidence/distribution.h"

namespace plumb::checks {
namespace {

constexpr std::string_view claim_id = "sampler/density";

struct Answer {
    std::vector<std::uint64_t> counts;  // one a cell; the last: outside of them all
    std::string outside;                // the first line that was
    std::uint64_t lines = 0, outside_line = 0;
};

std::string filled_in(std::string command, std::string_view place, std::uint64_t value) {
    for (std::size_t at = 0; (at = command.find(place, at)) != std::string::npos;)
        command.replace(at, place.size(), std::to_string(value));
    return command;
}

// One sample, `x` or `x,y`. Infinities and NaN are numbers: a sampler that returns them is wrong, not unreadable.
Point<2> parse_sample(std::string_view line, int dimension, std::uint64_t number) {
    const std::vector<std::string_view> fields = csv_fields(line);
    Point<2> point{};
    bool good = fields.size() == static_cast<std::size_t>(dimension);
    for (int axis = 0; axis < dimension && good; ++axis) {
        const std::optional<double> x = csv_number(fields[static_cast<std::size_t>(axis)]);
        good = x.has_value();
        if (good) point[axis] = *x;
    }
    if (good) return point;
    throw Error(fmt::format("line {} of the sampler is '{}'; accepted: {}", number, line.substr(0, 60),
                            dimension == 1 ? "a number, x" : "two numbers, x,y"));
}

Answer ask(const std::string& command, const CellDensity& density, std::uint64_t n,
           std::chrono::duration<double> limit) {
    Answer answer;
    answer.counts.resize(density.cells.size() + 1);
    const bool enough = read_lines(command, limit, [&](std::string_view line) {
        ++answer.lines;
        const std::size_t cell = density.cell_of(parse_sample(line, density.dimension, answer.lines));
        ++answer.counts[cell];
        if (answer.outside_line == 0 && (cell == density.cells.size() || density.cells[cell].probability == 0)) {
            answer.outside_line = answer.lines;
            answer.outside = line;
        }
        return answer.lines < n;
    });
    if (!enough) throw Error(fmt::format("'{}' ended after {} of {} lines", command, answer.lines, n));
    return answer;
}

std::string words(const CellDensity::Cell& cell, int dimension) {
    const std::string x = fmt::format("[{:.6g}, {:.6g})", cell.x.low, cell.x.high);
    return dimension == 1 ? x : fmt::format("{} x [{:.6g}, {:.6g})", x, cell.y.low, cell.y.high);
}

// The engine speaks of cells by number; whoever wrote the sampler thinks in x.
void explain(Verdict& verdict, const CellDensity& density, const Answer& answer) {
    if (answer.outside_line > 0) {
        std::uint64_t outside = answer.counts.back();
        for (std::size_t i = 0; i < density.cells.size(); ++i)
            if (density.cells[i].probability == 0) outside += answer.counts[i];
        verdict.reason = fmt::format("{} of {} samples fell where the density is zero, first line {}: '{}'", outside,
                                     answer.lines, answer.outside_line, answer.outside);
        return;
    }
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

}  // namespace

Catalogue sampler_catalogue(const SamplerTrial& trial, std::uint64_t seed, double alpha) {
    const CellDensity density = read_density(trial.density);
    DistributionClaim claim{.probabilities = {}, .delta = trial.delta};
    for (const CellDensity::Cell& cell : density.cells) claim.probabilities.push_back(cell.probability);

    const Run run(seed, claim_id, alpha);
    const std::uint64_t n = distribution_samples(claim, run.alpha(), run.beta());
    if (n > trial.most_samples)
        throw Error(
            fmt::format("delta {:g} and the rarest cell of '{}' ask for {} samples; accepted: at most {}; a larger "
                        "delta or likelier cells need fewer",
                        trial.delta, density.name, n, trial.most_samples));
    // Below 2^31: a positive int of every language.
    const std::uint64_t sampler_seed = run.random(0).bits() >> 33;
    const std::string command = filled_in(filled_in(trial.command, "{seed}", sampler_seed), "{n}", n);
    const Answer answer = ask(command, density, n, trial.timeout);

    Catalogue catalogue;
    catalogue.add({.id = std::string(claim_id),
                   .statement = fmt::format("`{}` draws from the density {}.", trial.command, density.name),
                   .source = fmt::format("the command line: --sampler, --density {}", density.name),
                   .kind = Kind::distribution,
                   .trial =
                       [=](const Run& judging) {
                           Verdict verdict = chi_square_verdict(answer.counts, claim, judging.alpha(), judging.beta());
                           explain(verdict, density, answer);
                           verdict.evidence.emplace_back("command", command);
                           return verdict;
                       },
                   .no_mutant = "the sampler is another program: a defect is its author's to plant"});
    return catalogue;
}

}  // namespace plumb::checks
