// Densities and discrete samplers: pdf is the derivative of the CDF, sample inverts it, and what is drawn follows it.
// Masses of cells come from the pdf by Gauss–Legendre quadrature, which is exact for (bi)linear pdfs and good to 1e-15
// for the exponentials on these cells.

#include <boost/math/quadrature/gauss.hpp>

#include "estimators/densities/density_2d.h"
#include "estimators/densities/piecewise_constant.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"

namespace plumb::suites {
namespace {

/// The three functions of a density, so that a mutant can change one.
struct DensityFunctions {
    std::function<double(double)> sample, pdf, invert;
};
template <class Density>
DensityFunctions functions_of(const Density& density) {
    return {[density](double u) { return density.sample(u); }, [density](double x) { return density.pdf(x); },
            [density](double x) { return density.invert(x); }};
}

struct DensityCase {
    std::string name, title, source;
    DensityFunctions right;
    DensityFunctions wrong_pdf;
    std::string pdf_defect;
    std::function<double(double)> wrong_sample;
    std::string sample_defect;
    std::function<double(double)> nearly_right_sample;  // phi = 0.06
    std::string small_defect;
};

double integral(const std::function<double(double)>& f, double from, double to) {
    return boost::math::quadrature::gauss<double, 15>::integrate(f, from, to);
}

std::vector<double> equal_cell_masses(const std::function<double(double)>& pdf, std::size_t cells) {
    std::vector<double> masses(cells);
    for (std::size_t i = 0; i < cells; ++i)
        masses[i] = integral(pdf, static_cast<double>(i) / static_cast<double>(cells),
                             static_cast<double>(i + 1) / static_cast<double>(cells));
    return masses;
}

/// The increments of the CDF are the integrals of the pdf, and the last value is 1.
Verdict pdf_is_derivative(const DensityFunctions& density) {
    constexpr std::size_t cells = 60;  // a multiple of the steps of the piecewise-constant density
    const std::vector<double> masses = equal_cell_masses(density.pdf, cells);
    std::vector<BoundedCase> errors{{"whole interval", std::abs(density.invert(1) - density.invert(0) - 1)}};
    for (std::size_t i = 0; i < cells; ++i) {
        const double from = static_cast<double>(i) / cells, to = static_cast<double>(i + 1) / cells;
        const double mass = density.invert(to) - density.invert(from);
        errors.push_back({fmt::format("{:.3f} to {:.3f}", from, to), std::abs(mass - masses[i]), from});
    }
    return within_bound(errors, 1e-14, "probability");
}

Verdict sample_inverts_cdf(const DensityFunctions& density) {
    std::vector<BoundedCase> errors;
    std::vector<double> us{0x1p-53, 0x1p-30, 1 - 0x1p-53};
    for (int i = 0; i < 1000; ++i) us.push_back(i / 1000.0);
    for (const double u : us) {
        const double x = density.sample(u);
        const bool inside = 0 <= x && x <= 1;
        errors.push_back({fmt::format("u = {}", u), inside ? std::abs(density.invert(x) - u) : 1.0, u});
    }
    return within_bound(errors, 1e-15, "of u");
}

Verdict samples_follow(const std::function<double(double)>& sample, const std::function<double(double)>& pdf,
                       const Run& run) {
    const auto draw = [&](RandomStream& random) { return equal_cell(sample(random.uniform()), 12); };
    return distribution_is(draw, {equal_cell_masses(pdf, 12), 0.02}, run);
}

std::vector<DensityCase> density_cases() {
    const LinearDensity linear(1, 3), swapped(3, 1);
    const TruncatedExponential exponential(3);
    const std::vector<double> steps{2, 0, 5, 1, 4, 3}, rotated{3, 2, 0, 5, 1, 4};
    DensityFunctions linear_mutant = functions_of(linear), exponential_mutant = functions_of(exponential),
                     steps_mutant = functions_of(PiecewiseConstant(steps));
    linear_mutant.pdf = [](double x) { return 1 + 2 * x; };
    exponential_mutant.pdf = [](double x) { return 3 * std::exp(-3 * x); };
    steps_mutant.pdf = [steps](double x) { return steps[static_cast<std::size_t>(x * 6)] / 15; };
    return {
        {"linear", "The linear density", "ours, estimators/densities/density.h", functions_of(linear), linear_mutant,
         "The values at the ends are not divided by their mean.", functions_of(swapped).sample,
         "The values at the ends are exchanged.", functions_of(LinearDensity(1, 4)).sample,
         "The value at 1 is 4, not 3."},
        {"exponential", "The truncated exponential", "ours, estimators/densities/density.h", functions_of(exponential),
         exponential_mutant, "The density lacks 1 − e^-λ, the mass of the interval.",
         [](double u) { return std::min(-std::log1p(-u) / 3, 1 - 0x1p-53); },
         "Draws of the untruncated exponential beyond 1 are moved to 1.",
         functions_of(TruncatedExponential(3.25)).sample, "The rate is 3.25, not 3."},
        {"steps", "The piecewise-constant density", "ours, estimators/densities/piecewise_constant.h",
         functions_of(PiecewiseConstant(steps)), steps_mutant, "The probability of a cell is not divided by its width.",
         functions_of(PiecewiseConstant(rotated)).sample, "The cells are off by one.",
         functions_of(PiecewiseConstant(std::vector<double>{2.4, 0, 5, 1, 4, 3})).sample,
         "The first weight is 2.4, not 2."},
    };
}

// ---- two dimensions

constexpr std::size_t side = 4;

template <class Density>
std::vector<double> square_masses(const Density& density) {
    std::vector<double> masses;
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const auto end = [](std::size_t k) { return static_cast<double>(k) / side; };
            masses.push_back(integral(
                [&](double y) {
                    return integral([&](double x) { return density.pdf({x, y}); }, end(i), end(i + 1));
                },
                end(j), end(j + 1)));
        }
    return masses;
}

using Sample2d = std::function<Point<2>(const Point<2>& u)>;

template <class Density>
Sample2d sample_of(const Density& density) {
    return [density](const Point<2>& u) { return density.sample(u); };
}

template <class Density>
Verdict points_follow(const Sample2d& sample, const Density& density, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const double u = random.uniform();
        const Point<2> p = sample({u, random.uniform()});
        return std::min(equal_cell(p[0], side) + side * equal_cell(p[1], side), side * side);
    };
    return distribution_is(draw, {square_masses(density), 0.05}, run);
}

/// y given x = 1/2, for every x.
struct BilinearWithMeanConditional {
    LinearDensity x{1, 7}, y{3, 5};
    [[nodiscard]] Point<2> sample(const Point<2>& u) const { return {x.sample(u[0]), y.sample(u[1])}; }
};

// ---- discrete pdfs

using Integers = std::vector<std::uint64_t>;

/// What each index gets from all columns, as n w_i.
using ThresholdOf = std::uint64_t (*)(const AliasTable<std::uint64_t>& table, std::size_t column);
Verdict alias_masses(ThresholdOf threshold_of) {
    std::uint64_t cases = 0;
    for (std::uint64_t code = 1; code < 5 * 5 * 5 * 5; ++code, ++cases) {
        const Integers weights{code % 5, code / 5 % 5, code / 25 % 5, code / 125};
        const AliasTable<std::uint64_t> table(weights);
        Integers mass(4);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint64_t own = threshold_of(table, i);
            mass[i] += own;
            mass[table.columns()[i].alias] += table.total() - own;
        }
        for (std::size_t i = 0; i < 4; ++i)
            if (mass[i] != 4 * weights[i])
                return exactly(false, cases + 1,
                               fmt::format("weights {}: index {} holds {}/{}", fmt::join(weights, ", "), i, mass[i],
                                           4 * table.total()));
    }
    return exactly(true, cases, "every index holds exactly its weight");
}

Verdict cdf_positions(std::uint64_t (*shift)(std::uint64_t position)) {
    std::uint64_t cases = 0;
    for (std::uint64_t code = 1; code < 5 * 5 * 5 * 5; ++code, ++cases) {
        const Integers weights{code % 5, code / 5 % 5, code / 25 % 5, code / 125};
        const DiscreteCdf<std::uint64_t> cdf(weights);
        Integers hits(4);
        for (std::uint64_t position = 0; position < cdf.total(); ++position) ++hits[cdf.at(shift(position))];
        if (hits != weights)
            return exactly(false, cases + 1,
                           fmt::format("weights {}: {} hits", fmt::join(weights, ", "), fmt::join(hits, ", ")));
    }
    return exactly(true, cases, "every index is hit exactly as often as its weight says");
}

const Integers discrete_weights{3, 0, 7, 1, 4, 5};

Verdict indices_follow(const DrawCell& draw, const Run& run) {
    DistributionClaim claim{{}, 0.05};
    for (const std::uint64_t w : discrete_weights) claim.probabilities.push_back(static_cast<double>(w) / 20);
    return distribution_is(draw, claim, run);
}

std::size_t alias_with_swapped_threshold(RandomStream& random) {
    static const AliasTable<std::uint64_t> table(discrete_weights);
    const std::size_t column = random.below(table.columns().size());
    const auto& [threshold, alias] = table.columns()[column];
    return random.below(table.total()) < table.total() - threshold ? column : alias;
}

void add_one_dimensional(Catalogue& catalogue, const DensityCase& density) {
    const std::string id = "density/" + density.name;
    catalogue.add({
        .id = id + "/pdf",
        .statement = density.title + "'s pdf is the derivative of its CDF and integrates to 1.",
        .source = density.source,
        .kind = Kind::bounded,
        .trial = {pdf_is_derivative, density.right, {{"off-by-normalisation", density.pdf_defect, density.wrong_pdf}}},
    });
    catalogue.add({
        .id = id + "/inverse",
        .statement = density.title + "'s sample() inverts its CDF and stays in [0, 1].",
        .source = density.source,
        .kind = Kind::bounded,
        .trial = {sample_inverts_cdf,
                  density.right,
                  {{"another-sampler",
                    density.sample_defect,
                    {density.wrong_sample, density.right.pdf, density.right.invert}}}},
    });
    catalogue.add({
        .id = id + "/distribution",
        .statement = density.title + "'s samples fall into cells with the integrals of its pdf.",
        .source = density.source,
        .kind = Kind::distribution,
        .trial = {[density](const std::function<double(double)>& sample, const Run& run) {
                      return samples_follow(sample, density.right.pdf, run);
                  },
                  density.right.sample,
                  {{"another-sampler", density.sample_defect, density.wrong_sample},
                   {"parameter-off", density.small_defect, density.nearly_right_sample}}},
    });
}

void add_two_dimensional(Catalogue& catalogue) {
    static const BilinearDensity bilinear(0, 4, 1, 3);
    static const ProductDensity<TruncatedExponential, LinearDensity> product{TruncatedExponential(2),
                                                                             LinearDensity(1, 3)};
    catalogue.add({
        .id = "density/bilinear/distribution",
        .statement = "The bilinear density's samples fall into cells with the integrals of its pdf.",
        .source = "ours, estimators/densities/density_2d.h",
        .kind = Kind::distribution,
        .trial = {[](const Sample2d& sample, const Run& run) { return points_follow(sample, bilinear, run); },
                  sample_of(bilinear),
                  {{"mean-conditional", "y is drawn from one density, whatever x is.",
                    sample_of(BilinearWithMeanConditional{})}}},
    });
    catalogue.add({
        .id = "density/product/distribution",
        .statement = "A product density's samples fall into cells with the integrals of its pdf.",
        .source = "ours, estimators/densities/density_2d.h",
        .kind = Kind::distribution,
        .trial = {[](const Sample2d& sample, const Run& run) { return points_follow(sample, product, run); },
                  sample_of(product),
                  {{"axis-left-uniform", "The second axis is not warped.",
                    sample_of(ProductDensity<TruncatedExponential, UniformDensity>{TruncatedExponential(2), {}})},
                   {"steeper-axis", "The second axis rises to 6, not 3.",
                    sample_of(ProductDensity<TruncatedExponential, LinearDensity>{TruncatedExponential(2),
                                                                                  LinearDensity(1, 6)})}}},
    });
}

void add_discrete(Catalogue& catalogue) {
    using Table = AliasTable<std::uint64_t>;
    const DiscreteCdf<std::uint64_t> cdf(discrete_weights);
    catalogue.add({
        .id = "discrete/alias/exact",
        .statement = "An alias table of integer weights gives every index exactly its weight.",
        .source = "[Vose 1991]",
        .kind = Kind::exact,
        .trial = {alias_masses,
                  [](const Table& t, std::size_t i) { return t.columns()[i].threshold; },
                  {{"swapped-threshold", "The alias gets the column's own part.",
                    [](const Table& t, std::size_t i) { return t.total() - t.columns()[i].threshold; }}}},
    });
    catalogue.add({
        .id = "discrete/cdf/exact",
        .statement = "CDF inversion of integer weights hits every index exactly as often as its weight says.",
        .source = "ours, estimators/densities/discrete.h",
        .kind = Kind::exact,
        .trial = {cdf_positions,
                  [](std::uint64_t position) { return position; },
                  {{"off-by-one", "Positions are counted from 1.",
                    [](std::uint64_t position) { return position + 1; }}}},
    });
    catalogue.add({
        .id = "discrete/alias/distribution",
        .statement = "Draws from an alias table follow the weights.",
        .source = "[Vose 1991]",
        .kind = Kind::distribution,
        .trial = {indices_follow,
                  [table = Table(discrete_weights)](RandomStream& random) { return table.sample(random); },
                  {{"swapped-threshold", "The alias gets the column's own part.", alias_with_swapped_threshold}}},
    });
    catalogue.add({
        .id = "discrete/cdf/distribution",
        .statement = "Draws by CDF inversion follow the weights.",
        .source = "ours, estimators/densities/discrete.h",
        .kind = Kind::distribution,
        .trial = {indices_follow,
                  [cdf](RandomStream& random) { return cdf.sample(random); },
                  {{"off-by-one", "Positions are counted from 1.",
                    [cdf](RandomStream& random) { return cdf.at(random.below(cdf.total()) + 1); }}}},
    });
}

}  // namespace

void add_densities_densities(Catalogue& catalogue) {
    for (const DensityCase& density : density_cases()) add_one_dimensional(catalogue, density);
    add_two_dimensional(catalogue);
    add_discrete(catalogue);
}

}  // namespace plumb::suites
