#include "reports/study/headline.h"

#include <array>
#include <cmath>

#include "reports/study/csv.h"
#include "reports/text/text.h"

namespace plumb::reports {
namespace {

constexpr std::array outcomes = {HeadlineOutcome::met, HeadlineOutcome::not_met, HeadlineOutcome::undecided,
                                 HeadlineOutcome::not_comparable};
constexpr std::array words = {"met", "not met", "undecided", "not comparable"};

std::string finite_cell(double x) {
    return std::isfinite(x) ? csv_cell(x) : "";
}

}  // namespace

std::string to_string(HeadlineOutcome outcome) {
    return words.at(static_cast<std::size_t>(outcome));
}

HeadlineOutcome outcome_of(const Interval& stated, const Interval& measured) {
    if (measured.inside(stated)) return HeadlineOutcome::met;
    return measured.disjoint(stated) ? HeadlineOutcome::not_met : HeadlineOutcome::undecided;
}

std::string bound_text(const Interval& stated) {
    if (stated.bounded()) return fmt::format("[{}, {}]", readable(stated.low), readable(stated.high));
    if (std::isfinite(stated.high)) return "at most " + readable(stated.high);
    return std::isfinite(stated.low) ? "at least " + readable(stated.low) : "–";
}

std::string measured_text(const Headline& headline) {
    if (std::isnan(headline.value)) return "–";
    if (!headline.interval.bounded()) return readable(headline.value);
    return fmt::format("{} [{}, {}]", readable(headline.value), readable(headline.interval.low),
                       readable(headline.interval.high));
}

std::string headline_summary(const std::vector<Headline>& headlines) {
    std::string text;
    for (const HeadlineOutcome outcome : outcomes)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                            std::ranges::count(headlines, outcome, &Headline::outcome), to_string(outcome));
    return text;
}

std::string headline_table(const std::vector<Headline>& headlines, const TableStyle& style) {
    if (headlines.empty()) return "";
    std::vector<std::vector<std::string>> rows;
    for (const Headline& h : headlines)
        rows.push_back({to_string(h.outcome), shortened(h.place, 24), bound_text(h.stated), measured_text(h),
                        h.measure.empty() ? h.reason : h.measure});
    return table({{"outcome"}, {"place"}, {"stated"}, {"measured"}, {"what"}}, rows,
                 static_cast<std::size_t>(style.width)) +
           headline_summary(headlines) + "\n";
}

std::string headline_csv(const std::vector<Headline>& headlines) {
    std::string csv =
        "source,place,states,figure,measure,stated_low,stated_high,measured,low,high,outcome,reason,remark,quoted\r\n";
    for (const Headline& h : headlines)
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", csv_cell(h.source), csv_cell(h.place),
                           csv_cell(h.states), csv_cell(h.figure), csv_cell(h.measure), finite_cell(h.stated.low),
                           finite_cell(h.stated.high), finite_cell(h.value), finite_cell(h.interval.low),
                           finite_cell(h.interval.high), to_string(h.outcome), csv_cell(h.reason), csv_cell(h.remark),
                           h.quoted ? "yes" : "no");
    return csv;
}

}  // namespace plumb::reports
