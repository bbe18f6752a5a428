// Jacobians of the hybrid shift against differences: the numbers of the directions at the connection and behind it are
// moved, the base is traced anew, shifted, and led back to numbers that `path` would have needed. All other numbers are
// kept and those before the connection decide where y_k is, so that the matrix of all derivatives is block triangular:
// its determinant is that of these two or four numbers.

#include "verification/evidence/deterministic.h"
#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

// Numbers of the direction at the connection, then those behind it.
using Numbers = std::array<double, 4>;

// A lobe of which the numbers of a direction are a smooth function: mixtures have several numbers for a direction.
bool single_lobe(const PathVertex& vertex) {
    return std::holds_alternative<Diffuse>(vertex.bsdf.model) ||
           std::holds_alternative<RoughConductor>(vertex.bsdf.model);
}

// Of the square's four triangles, in each of which the map to the disk is smooth.
int triangle_of(double u, double v) {
    const double a = 2 * u - 1, b = 2 * v - 1;
    return 2 * (a + b > 0) + (a - b > 0);
}
bool apart(const Numbers& a, const Numbers& b) {
    return triangle_of(a[0], a[1]) != triangle_of(b[0], b[1]) || triangle_of(a[2], a[3]) != triangle_of(b[2], b[3]);
}

// Of the leading rows and columns, by Gauss's elimination.
double determinant(std::array<Numbers, 4> columns, std::size_t size) {
    double product = 1;
    for (std::size_t i = 0; i < size; ++i) {
        std::size_t pivot = i;
        for (std::size_t j = i + 1; j < size; ++j)
            if (std::abs(columns[j][i]) > std::abs(columns[pivot][i])) pivot = j;
        if (pivot != i) std::swap(columns[i], columns[pivot]), product = -product;
        product *= columns[i][i];
        for (std::size_t j = i + 1; j < size; ++j)
            for (std::size_t row = size; row-- > i;) columns[j][row] -= columns[j][i] / columns[i][i] * columns[i][row];
    }
    return product;
}

// The shift of one path as a function of its numbers at the connection.
class Differences {
public:
    Differences(const PixelPair& pixels, const PathShift& shift, PrimarySamples& numbers)
        : pixels_(pixels), shift_(shift), numbers_(numbers) {
        here_ = shifted(numbers_);
        if (!here_ || !single_lobe(base_.record.vertices[k() - 1]) || !single_lobe(shifted_.record.vertices[k() - 1])) {
            here_ = {};
            return;
        }
        hit_ = hit();
        place_ = {numbers_.at(slot(0)).u[0], numbers_.at(slot(0)).u[1], numbers_.at(slot(1)).u[0],
                  numbers_.at(slot(1)).u[1]};
        four_ =
            hit_ && base_.parts > k() + 1 && shifted_.parts[k() + 1].valid() && single_lobe(base_.record.vertices[k()]);
        jacobians_ = {shifted_.parts[k()].jacobian, four_ ? shifted_.parts[k() + 1].jacobian : 0};
    }

    // Of the part at the connection, and of those behind it where there are any: the relative error of the Jacobian.
    void measure(std::vector<double>& errors);

private:
    [[nodiscard]] std::size_t k() const { return base_.connection; }
    [[nodiscard]] Slot slot(std::size_t behind) const {
        return {static_cast<std::uint16_t>(k_ + behind), Use::direction};
    }
    [[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> hit() const {
        if (base_.record.vertices.size() <= k()) return {};
        const Hit& hit = base_.record.vertices[k()].hit;
        return std::pair(hit.shape, hit.primitive);
    }
    std::optional<Numbers> shifted(PrimarySamples& numbers);
    std::optional<Numbers> moved(std::size_t axis, double step);

    PixelPair pixels_;
    const PathShift& shift_;
    PrimarySamples& numbers_;
    BasePath base_;
    ShiftedPath shifted_;
    std::optional<Numbers> here_;
    std::optional<std::pair<std::uint32_t, std::uint32_t>> hit_;
    Numbers place_{};
    std::size_t k_ = 0;
    bool four_ = false;
    std::array<double, 2> jacobians_{};
};

std::optional<Numbers> Differences::shifted(PrimarySamples& numbers) {
    shift_.trace(pixels_.scene, pixels_.from, numbers, base_);
    shift_.shift(pixels_.scene, base_, pixels_.to, numbers, shifted_);
    const auto found = numbers_of_shift(pixels_.scene, base_, shifted_);
    if (!found) return {};
    if (k_ == 0) k_ = k();
    const auto& at = *found->at_connection;
    const std::array<double, 3> beyond = found->beyond.value_or(std::array<double, 3>{0, 0.25, 0.5});
    return Numbers{at[1], at[2], beyond[1], beyond[2]};
}

std::optional<Numbers> Differences::moved(std::size_t axis, double step) {
    Numbers place = place_;
    place[axis] += step;
    if (!(place[axis] > 0 && place[axis] < 1) || apart(place, place_)) return {};
    Replaced numbers(numbers_);
    numbers.set(slot(0), {place[0], place[1]});
    numbers.set(slot(1), {place[2], place[3]});
    const auto result = shifted(numbers);
    if (!result || k() != k_ || hit() != hit_ || apart(*result, *here_)) return {};
    return result;
}

void Differences::measure(std::vector<double>& errors) {
    if (!here_) return;
    constexpr double h = 4e-3;
    const std::size_t size = four_ ? 4 : 2;
    std::array<Numbers, 4> slopes{};  // by column
    for (std::size_t axis = 0; axis < size; ++axis) {
        std::array<Numbers, 4> at;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto found = moved(axis, std::array{-2., -1., 1., 2.}[i] * h);
            if (!found) return;
            at[i] = *found;
        }
        for (std::size_t row = 0; row < size; ++row)
            slopes[axis][row] = (8 * (at[2][row] - at[1][row]) - (at[3][row] - at[0][row])) / (12 * h);
    }
    const auto error = [](double scale, double jacobian) { return std::abs(std::abs(scale) / jacobian - 1); };
    errors.push_back(error(determinant(slopes, 2), jacobians_[0]));
    if (four_) errors.push_back(error(determinant(slopes, 4), jacobians_[1]));
}

Verdict jacobians_are_differences(const MakeShift& make, const Run& run) {
    const PathTracer tracer;
    const auto shift = make(tracer);
    std::vector<std::pair<std::string, std::vector<double>>> deviations;
    const std::uint64_t seed = run.random(0).bits();
    for (const auto& [name, pixels] : shift_scenes()) {
        std::vector<double>& errors = deviations.emplace_back(name, std::vector<double>()).second;
        for (std::uint32_t i = 0; i < run.pick(150u, 2'000u); ++i) {
            run.end_if_stopped();
            IndependentSamples numbers({seed, 0, i});
            Differences(pixels, *shift, numbers).measure(errors);
        }
    }
    return nearly_all_agree(deviations);
}

double without_density(const Connection&) {
    return 1;
}

}  // namespace

void add_shift_jacobians(Catalogue& catalogue) {
    catalogue.add({.id = "shift/path/jacobian",
                   .statement =
                       "The Jacobian of a shift is the determinant of the derivatives of the numbers that lead to the "
                       "shifted path by those that lead to its base.",
                   .source = "ours, integrators/estimators/hybrid_shift.h",
                   .kind = Kind::bounded,
                   .trial = {jacobians_are_differences,
                             hybrid,
                             {{"dropped", "The Jacobian is 1.", (hybrid_by(without_density, without_density))},
                              {"inverted", "The Jacobian is that of the shift back.",
                               (hybrid_by([](const Connection& c) { return 1 / connection_density(c); },
                                          [](const Connection& c) { return 1 / density_beyond(c); }))},
                              {"no-cos", "The Jacobian lacks the cosines at the far end.",
                               (hybrid_by([](const Connection& c) { return c.pdf / (c.distance * c.distance); }))},
                              {"no-distance", "The Jacobian lacks the squared distances.",
                               (hybrid_by([](const Connection& c) { return c.pdf * c.cos; }))},
                              {"no-pdf", "The Jacobian lacks the ratio of densities at the connection.",
                               (hybrid_by([](const Connection& c) { return c.cos / (c.distance * c.distance); }))},
                              {"no-pdf-beyond", "The Jacobian lacks the ratio of densities behind the connection.",
                               (hybrid_by(connection_density, without_density))}}}});
}

}  // namespace plumb::suites
