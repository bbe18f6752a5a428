#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/interval.h"
#include "verification/series.h"

namespace plumb {

/// The three outcomes. `holds` needs evidence of its own (the bias is smaller than delta); "not rejected" alone is
/// `undecided`.
enum class Outcome { holds, refuted, undecided };

/// The kinds of evidence, which say what a verdict is worth: docs/statistics.md has a section for each.
enum class Kind { exact, bounded, distribution, mean, ratio, rate, cost };

std::string to_string(Outcome outcome);
std::string to_string(Kind kind);
std::ostream& operator<<(std::ostream& out, Outcome outcome);  ///< so that test frameworks print the word
Outcome outcome_from(std::string_view text);                   ///< throws Error on another word

/// One named value of the evidence, in the order in which a reader wants them.
using FieldValue = std::variant<double, std::uint64_t, std::string, std::vector<double>>;
using Field = std::pair<std::string, FieldValue>;

/// The answer to a claim: a pure value, which neither prints nor throws.
struct [[nodiscard]] Verdict {
    Outcome outcome = Outcome::undecided;
    double statistic = std::numeric_limits<double>::quiet_NaN();  ///< NaN where the evidence has none
    double p_value = std::numeric_limits<double>::quiet_NaN();    ///< likewise
    Interval deviation{};  ///< of what was measured from what was claimed, in the claim's unit
    double resolution = std::numeric_limits<double>::quiet_NaN();  ///< the largest deviation that could still hide
    std::uint64_t samples = 0;
    std::string reason;  ///< one sentence, fit for a report
    std::vector<Field> evidence;
    std::vector<Series> series;        ///< convergence measured on the way
    std::vector<Stability> stability;  ///< relative errors over hard cases
};

/// The verdict in one line, for whoever reads no report: the outcome, the reason, and the number of samples.
std::string describe(const Verdict& verdict);
std::ostream& operator<<(std::ostream& out, const Verdict& verdict);  ///< describe()

/// Several verdicts as one: refuted if any is, else undecided if any is, else holds. Samples add up; series and
/// stability are joined; the numbers are those of the part that decided.
Verdict all_of(std::vector<Verdict> parts);

}  // namespace plumb
