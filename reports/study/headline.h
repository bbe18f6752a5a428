#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/interval.h"
#include "reports/run/table.h"

namespace plumb::reports {

/// The relation of a statement of a source to what was measured. `undecided` means that the measured interval reaches
/// across an end of the stated one.
enum class HeadlineOutcome { met, not_met, undecided, not_comparable };
/// The outcome in words: "met", "not met", "undecided" or "not comparable".
std::string to_string(HeadlineOutcome outcome);

/// The confidence of the intervals that headlines are decided by: with forty true statements at the edge of their
/// bounds, one run in fifty gets one wrong (docs/studies.md).
constexpr double headline_level = 0.999;

/// The outcome for a stated and a measured interval.
HeadlineOutcome outcome_of(const Interval& stated, const Interval& measured);

/// A statement of a source beside what was measured of it.
struct Headline {
    std::string source, place;  ///< the paper; its figure, table or sentence
    std::string states;         ///< what the source states
    bool quoted = false;        ///< in the source's own words; else in ours
    std::string figure = {};    ///< id of the study's figure that shows it; empty where nothing is measured
    std::string measure = {};   ///< what is measured, in words: "MSE of A / MSE of B on exp, n = 1024"
    Interval stated = {};       ///< the statement as a bound of that number
    double value = 0;           ///< measured, NaN where nothing could be
    Interval interval = {};     ///< of `value`, at headline_level
    bool logarithmic = false;   ///< a positive number, to be drawn on a logarithmic axis
    HeadlineOutcome outcome = HeadlineOutcome::not_comparable;
    std::string reason = {};  ///< why it cannot be compared; else empty
    std::string remark = {};  ///< what else there is to say, from the study's file; may be empty
};

/// The bound as text: "[−4.3, −3.7]", "at most 1", "at least 0.001"; "–" when it says nothing.
std::string bound_text(const Interval& stated);
/// The measured number as text: "−3.98 [−4.01, −3.95]"; "–" for NaN.
std::string measured_text(const Headline& headline);
/// The outcomes in one line: "3 met, 1 not met, 1 undecided, 2 not comparable".
std::string headline_summary(const std::vector<Headline>& headlines);

/// The headlines as text, a line for each, then the summary; nothing when there are none.
std::string headline_table(const std::vector<Headline>& headlines, const TableStyle& style = {});
/// Its rows: source, place, states, figure, measure, stated_low, stated_high, measured, low, high, outcome, reason,
/// remark, quoted (yes or no). RFC 4180; what is unknown or unbounded is an empty cell.
std::string headline_csv(const std::vector<Headline>& headlines);

}  // namespace plumb::reports
