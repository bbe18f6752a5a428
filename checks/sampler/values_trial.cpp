#include "checks/sampler/values_trial.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <unordered_map>

#include "checks/sampler/lines.h"
#include "core/box.h"
#include "core/error.h"
#include "verification/evidence/mean.h"

namespace plumb::checks {
namespace {

constexpr const char* no_mutant = "the sampler is another program: a defect is its author's to plant";
constexpr std::size_t cells_of_own = 8;  // along x in one dimension, 4 by 2 in two
constexpr double default_delta = 0.05;

// The verdict on a mean of values that are there already: a draw finds its value by the random numbers that it is
// given, so that it may be asked again, and by any thread.
Verdict mean_of_values(std::size_t count, const std::function<double(std::size_t, RandomStream&)>& value,
                       MeanClaim claim, const Run& run) {
    claim.cap = count;
    claim.why_fewer = "these are all the values that there are";
    std::unordered_map<std::uint64_t, std::size_t> index_of;
    index_of.reserve(count);
    for (std::size_t i = 0; i < count; ++i) index_of.emplace(run.random(i).bits(), i);
    const auto draw = [&](RandomStream& random) {
        RandomStream key = random;
        return value(index_of.at(key.bits()), random);
    };
    return mean_is(draw, claim, run);
}

// Twice the value or nothing, at the toss of a coin: with the same mean, and with a spread where all values are the
// same, as those of a uniform density; without any a mean test decides nothing.
double halved(double value, RandomStream& random) {
    return random.uniform() < 0.5 ? 2 * value : 0;
}

template <int D>
struct OwnSample {
    Point<D> at{};
    double pdf = 0;
};

template <int D>
Box<D> domain_of(const std::vector<double>& ends) {
    Box<D> box;
    for (std::size_t axis = 0; axis < D && !ends.empty(); ++axis) {
        box.low[axis] = ends[2 * axis];
        box.high[axis] = ends[2 * axis + 1];
    }
    return box;
}

template <int D>
std::size_t cell_of(const Box<D>& box, const Point<D>& at) {
    const auto along = [&](int axis, std::size_t cells) {
        const double u = box.to_unit(at[axis], axis);
        return std::min(cells - 1, static_cast<std::size_t>(u * static_cast<double>(cells)));
    };
    if constexpr (D == 1)
        return along(0, cells_of_own);
    else
        return along(0, 4) * 2 + along(1, 2);
}

// The worst of the cells: refuted where one is, holds where all do.
template <int D>
Verdict every_cell(const std::vector<OwnSample<D>>& samples, const Box<D>& box, double delta, const Run& run) {
    const double size = box.volume() / cells_of_own;
    Verdict worst;
    for (std::size_t cell = 0; cell < cells_of_own; ++cell) {
        const auto value = [&](std::size_t i, RandomStream&) {
            return cell_of<D>(box, samples[i].at) == cell ? 1 / samples[i].pdf : 0;
        };
        const MeanClaim claim{
            .reference = size, .delta = delta * size, .bounds = {0, std::numeric_limits<double>::infinity()}};
        Verdict found =
            mean_of_values(samples.size(), value, claim, run.part(fmt::format("cell {}", cell), 1.0 / cells_of_own));
        found.reason =
            fmt::format("cell {} of {}, whose size is {:.4g}: {}", cell + 1, cells_of_own, size, found.reason);
        const auto rank = [](Outcome outcome) {
            return outcome == Outcome::refuted ? 2 : outcome == Outcome::undecided ? 1 : 0;
        };
        if (cell == 0 || rank(found.outcome) > rank(worst.outcome)) worst = std::move(found);
    }
    if (worst.outcome == Outcome::holds)
        worst.reason = fmt::format(
            "in each of {} cells the mean of 1/pdf is the cell's size: an error of {:.2g} % is "
            "excluded; looked nowhere within them",
            cells_of_own, 100 * delta);
    return worst;
}

// A sample that cannot have been drawn so; empty where there is none.
template <int D>
std::string impossible(const OwnSample<D>& sample, const Box<D>& box, std::string_view line, std::uint64_t number) {
    for (int axis = 0; axis < D; ++axis)
        if (!box.contains(sample.at[axis], axis))
            return fmt::format("line {}, '{}', lies outside the domain; accepted: {} to {} (see --domain)", number,
                               line.substr(0, 60), box.low[axis], box.high[axis]);
    if (!(sample.pdf > 0 && std::isfinite(sample.pdf)))
        return fmt::format("line {}, '{}', says that its density is {}: nothing is drawn there", number,
                           line.substr(0, 60), sample.pdf);
    return {};
}

template <int D>
void add_own(Catalogue& catalogue, const SamplerTrial& trial, std::uint64_t seed) {
    const Box<D> box = domain_of<D>(trial.domain);
    const double delta = trial.delta.value_or(ErrorTarget{default_delta, true}).error;
    const auto samples = std::make_shared<std::vector<OwnSample<D>>>();
    std::string wrong;
    const auto use = [&](std::span<const double> numbers, std::string_view line, std::uint64_t number) {
        OwnSample<D> sample{.at = {}, .pdf = numbers.back()};
        for (int axis = 0; axis < D; ++axis) sample.at[axis] = numbers[static_cast<std::size_t>(axis)];
        if (wrong.empty()) wrong = impossible(sample, box, line, number);
        samples->push_back(sample);
    };
    for_lines(command_for(trial, seed, trial.samples), trial, trial.samples, D + 1, D + 1,
              D == 1 ? "two numbers, x,pdf" : "three numbers, x,y,pdf", use);
    const auto judged = [wrong](const auto& check) {
        return [wrong, check](const Run& run) {
            if (wrong.empty()) return check(run);
            Verdict verdict;
            verdict.outcome = Outcome::refuted;
            verdict.reason = wrong;
            return verdict;
        };
    };
    const MeanClaim whole{.reference = box.volume(),
                          .delta = delta * box.volume(),
                          .bounds = {0, std::numeric_limits<double>::infinity()}};
    catalogue.add({.id = "sampler/normalisation",
                   .statement = fmt::format("The density that `{}` prints integrates to 1.", trial.command),
                   .source = "the command line: --sampler, --density own",
                   .kind = Kind::mean,
                   .trial = judged([=](const Run& run) {
                       return mean_of_values(
                           samples->size(),
                           [&](std::size_t i, RandomStream& random) { return halved(1 / (*samples)[i].pdf, random); },
                           whole, run);
                   }),
                   .no_mutant = no_mutant});
    catalogue.add({.id = "sampler/density",
                   .statement = fmt::format("`{}` draws from the density that it prints.", trial.command),
                   .source = "the command line: --sampler, --density own",
                   .kind = Kind::distribution,
                   .trial = judged([=](const Run& run) { return every_cell(*samples, box, delta, run); }),
                   .no_mutant = no_mutant});
}

}  // namespace

void add_own_density(Catalogue& catalogue, const SamplerTrial& trial, std::uint64_t seed) {
    if (trial.domain.size() == 4)
        add_own<2>(catalogue, trial, seed);
    else
        add_own<1>(catalogue, trial, seed);
}

void add_mean(Catalogue& catalogue, const SamplerTrial& trial, std::uint64_t seed) {
    if (!trial.mean) throw Error("--sampler: judged by what? Give --density, or --mean and --delta");
    if (!trial.delta) throw Error("--mean needs --delta, the bias that `holds` excludes: 1e-3, or 1% of the mean");
    const double delta = trial.delta->absolute(*trial.mean);
    if (!(delta > 0)) throw Error("--delta: a share of a mean that is 0; accepted: 1e-3");
    const auto values = std::make_shared<std::vector<double>>();
    for_lines(command_for(trial, seed, trial.samples), trial, trial.samples, 1, 1, "a number, a value",
              [&](std::span<const double> numbers, std::string_view, std::uint64_t) { values->push_back(numbers[0]); });
    catalogue.add({.id = "sampler/mean",
                   .statement = fmt::format("The values of `{}` have the mean {:g}.", trial.command, *trial.mean),
                   .source = fmt::format("the command line: --sampler, --mean {:g}", *trial.mean),
                   .kind = Kind::mean,
                   .trial =
                       [=, reference = *trial.mean](const Run& run) {
                           return mean_of_values(
                               values->size(), [&](std::size_t i, RandomStream&) { return (*values)[i]; },
                               {.reference = reference, .delta = delta}, run);
                       },
                   .no_mutant = no_mutant});
}

}  // namespace plumb::checks
