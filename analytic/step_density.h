#pragma once

#include <span>
#include <vector>

namespace plumb {

/// A density on [0,1] that is constant on each of K pieces: sample() is the inverse of the distribution function, which
/// is invert().
class StepDensity {
public:
    /// edges: K+1 increasing values from 0 to 1; masses: K positive probabilities, normalised to sum 1 here.
    /// Throws Error naming the edge or mass that is not.
    StepDensity(std::vector<double> edges, std::vector<double> masses);

    /// K equal pieces with these masses.
    static StepDensity equal_pieces(std::vector<double> masses);

    [[nodiscard]] std::size_t pieces() const { return masses_.size(); }
    [[nodiscard]] std::span<const double> edges() const { return edges_; }
    [[nodiscard]] std::span<const double> masses() const { return masses_; }

    [[nodiscard]] double pdf(double x) const;
    [[nodiscard]] double invert(double x) const;
    [[nodiscard]] double sample(double u) const;

private:
    std::vector<double> edges_, masses_, cumulative_;
};

}  // namespace plumb
