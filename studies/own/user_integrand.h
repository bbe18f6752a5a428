#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/csv.h"
#include "estimators/estimator.h"
#include "estimators/replicates/integration.h"

namespace plumb::own {

/// An integral that a person asks for.
struct IntegralTask {
    std::vector<std::string> what;  ///< a formula, @id, an image, or files of samples
    std::optional<std::string> method;
    std::optional<std::uint64_t> n;    ///< samples a run
    std::optional<ErrorTarget> error;  ///< instead of n
    std::uint64_t replicates = 32, max_evaluations = 100'000'000;
    std::optional<std::uint64_t> batches;  ///< how many sets a file of samples is cut into
    std::vector<double> domain;            ///< x0, x1[, y0, y1]; empty: the unit cube
    std::optional<std::string> channel, lookup;
    std::function<void(double share, const Runs& seen)> progress = {};  ///< told of the share that is done, about
};

/// The kinds of input that a person may ask to integrate.
enum class InputKind { formula, shipped, image, samples };
InputKind kind_of(const std::string& what);

/// A person's integrand, moved to the unit cube: its integral there is that over the person's domain.
template <int D>
struct UserIntegrand {
    std::string name;
    Function<D> value;  ///< throws Error where it is not finite; each thread needs a copy of its own
    std::optional<double> exact;
    const Integrand<D>* shipped = nullptr;  ///< where it is one of Plumb's own
};
using UserIntegrands = std::variant<std::vector<UserIntegrand<1>>, std::vector<UserIntegrand<2>>>;

/// The formula, the shipped integrand or the channels of the image that the task names. Throws Error.
UserIntegrands read_integrands(const IntegralTask& task);

/// Samples that a person drew, in the unit cube, with the integrand's values there (times the domain's volume).
template <int D>
struct SampleSet {
    std::vector<Point<D>> places;
    std::vector<double> values;
};
/// Columns 0 … D−1 of a table as points of the unit cube. Throws Error naming the line of a point outside the domain.
template <int D>
std::vector<Point<D>> places_of(const NumberTable& table, const std::vector<double>& domain);
template <int D>
SampleSet<D> samples_of(const NumberTable& table, const std::vector<double>& domain);

}  // namespace plumb::own
