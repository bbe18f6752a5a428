#include <algorithm>
#include <cmath>

#include "checks/bsdf/arithmetic.h"
#include "checks/bsdf/check_bsdf.h"
#include "checks/bsdf/directions.h"
#include "checks/bsdf/mass.h"
#include "core/parallel.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"

namespace plumb::checks {
namespace {

// The cells of one direction: runs of parts of the sphere of some 1/16 of the mass each, then one for discrete samples
// and one for lost ones where they are not too rare; what is rarer than 1/24 joins the cell before it.
constexpr double cell_mass = 1.0 / 16, least_mass = 1.0 / 24, delta = 0.05;

struct Cells {
    Vec3 wo;
    SphereIntegral density;
    DistributionClaim claim;
    std::vector<std::size_t> cell_of_part;
    std::size_t discrete_cell, lost_cell;
    double excess;  // of the whole mass over 1
};

class CellMaker {
public:
    std::size_t add(double mass, double error) {  // to the open cell, which it closes when full
        const std::size_t cell = claim_.probabilities.size();
        mass_ += std::max(0.0, mass);
        error_ += error;
        if (mass_ >= cell_mass) close();
        return cell;
    }
    std::size_t add_apart(double mass, double error) {
        if (mass_ > least_mass) close();
        const std::size_t cell = add(mass, error);
        if (mass_ > least_mass) close();
        return cell;
    }
    DistributionClaim done() {
        if (mass_ > 0 && claim_.probabilities.empty()) close();
        if (!claim_.probabilities.empty()) {
            claim_.probabilities.back() += mass_;
            claim_.errors.back() += error_;
        }
        double total = 0;
        for (const double p : claim_.probabilities) total += p;
        for (double& p : claim_.probabilities) p /= total;
        return std::move(claim_);
    }

private:
    void close() {
        claim_.probabilities.push_back(mass_);
        claim_.errors.push_back(error_);
        mass_ = error_ = 0;
    }

    DistributionClaim claim_{{}, delta};
    double mass_ = 0, error_ = 0;
};

Cells cells_at(const BsdfSubject& bsdf, const BsdfTraits& traits, Vec3 wo, RandomStream& random, double epsilon) {
    const Mass mass = mass_of(bsdf, traits, bsdf.pdf, wo, random, epsilon, cell_mass / 2);
    Cells cells{wo, mass.integral, {}, {}, 0, 0, 0};
    const double discrete = bsdf.discrete ? bsdf.discrete(wo) : mass.met.discrete();
    CellMaker maker;
    for (std::size_t i = 0; i < cells.density.parts(); ++i)
        cells.cell_of_part.push_back(maker.add(cells.density.part(i).value, cells.density.part(i).error));
    cells.discrete_cell = maker.add_apart(discrete, 0);
    cells.lost_cell = maker.add_apart(std::max(0.0, 1 - mass.total() - discrete), mass.integral.error());
    cells.excess = mass.total() - mass.error() + discrete - 1;
    cells.claim = maker.done();
    const std::size_t last = std::max<std::size_t>(1, cells.claim.probabilities.size()) - 1;
    for (std::size_t* cell : {&cells.discrete_cell, &cells.lost_cell}) *cell = std::min(*cell, last);
    for (std::size_t& cell : cells.cell_of_part) cell = std::min(cell, last);
    return cells;
}

std::size_t cell_of(const BsdfSubject& bsdf, const Cells& cells, const std::optional<BsdfSample>& sample) {
    if (!sample) return cells.lost_cell;
    const std::size_t outside = cells.claim.probabilities.size();
    if (sample->measure == Measure::solid_angle)
        return cells.density.total() > 0 ? cells.cell_of_part[cells.density.part_of(sample->wi)] : outside;
    return bsdf.discrete && bsdf.discrete(cells.wo) == 0 ? outside : cells.discrete_cell;
}

std::string place_of(const Cells& cells, std::size_t cell) {
    std::string words;
    if (cell == cells.lost_cell) words = "lost samples";
    if (cell == cells.discrete_cell) words += words.empty() ? "discrete samples" : " and discrete ones";
    const auto first = std::ranges::find(cells.cell_of_part, cell);
    if (first == cells.cell_of_part.end()) return words + ", wo " + name_of(cells.wo);
    const auto last = std::ranges::find_if(first, cells.cell_of_part.end(), [&](std::size_t c) { return c != cell; });
    const auto middle = static_cast<std::size_t>(first + (last - first) / 2 - cells.cell_of_part.begin());
    return (words.empty() ? "" : words + " and ") + "about " + in_words(cells.wo, cells.density.middle(middle));
}

Verdict at_one_direction(const BsdfSubject& bsdf, const Cells& cells, double epsilon, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const Transport transport = random.bits() % 2 ? Transport::radiance : Transport::importance;
        return cell_of(bsdf, cells, bsdf.sample(cells.wo, uniforms(random, epsilon), transport));
    };
    if (cells.claim.probabilities.size() < 2) {  // all of one kind
        constexpr std::uint64_t tries = 4096;
        for (std::uint64_t i = 0; i < tries; ++i)
            if (RandomStream random = run.random(i); draw(random) != 0)
                return exactly(false, i, "a sample fell where the density is zero, wo " + name_of(cells.wo));
        return exactly(true, tries, "all samples are of one kind");
    }
    Verdict verdict = distribution_is(draw, cells.claim, run);
    for (const auto& [name, value] : verdict.evidence) {
        if (name != "worst_cell") continue;
        const auto cell = std::get<std::uint64_t>(value);
        const double q = cells.claim.probabilities[cell], n = static_cast<double>(verdict.samples);
        const double z = std::get<double>(std::ranges::find(verdict.evidence, "worst_cell_z", &Field::first)->second);
        verdict.reason +=
            fmt::format(" ({:.4g} of the samples for {:.4g}): {}", q + z * std::sqrt(q / n), q, place_of(cells, cell));
        break;
    }
    return verdict;
}

}  // namespace

Verdict samples_follow_pdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const double epsilon = epsilon_of(bsdf, traits, run);
    const std::vector<Vec3> directions = check_directions(run);
    std::vector<std::optional<Cells>> tables(directions.size());
    for_batches(directions.size(), [&](std::size_t i) {
        RandomStream random = run.part("pilot").random(i);
        tables[i] = cells_at(bsdf, traits, representable(directions[i], epsilon), random, epsilon);
    });
    std::vector<Verdict> verdicts;
    double least_p = 1;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (!(tables[i]->excess < 1e-3))
            return within_bound({{"wo " + name_of(tables[i]->wo), tables[i]->excess}}, 1e-3, "of probability above 1");
        const double share = 1 / static_cast<double>(tables.size());
        verdicts.push_back(
            at_one_direction(bsdf, *tables[i], epsilon, run.part(fmt::format("direction {}", i), share)));
        if (verdicts.back().p_value < least_p) least_p = verdicts.back().p_value;
    }
    Verdict verdict = all_of(std::move(verdicts));
    verdict.p_value = std::min(1.0, least_p * static_cast<double>(tables.size()));
    if (verdict.outcome == Outcome::holds)
        verdict.reason =
            fmt::format("a density error phi of {} is excluded at each of {} directions (least p of all {:.2g})", delta,
                        tables.size(), verdict.p_value);
    return verdict;
}

}  // namespace plumb::checks
