#include "reports/run/table.h"

#include <fmt/format.h>

#include "reports/run/metric.h"
#include "reports/text/text.h"

namespace plumb::reports {
namespace {

constexpr const char* green = "\033[32m";
constexpr const char* red = "\033[1;31m";
constexpr const char* yellow = "\033[33m";
constexpr const char* plain = "\033[0m";

std::string in_colour(const std::string& text, const char* colour) {
    return colour + text + plain;
}

/// Colours the words that say an outcome.
std::string paint_outcome(std::size_t, const std::string& cell) {
    if (cell.starts_with("holds") || cell.starts_with("inside")) return in_colour(cell, green);
    if (cell.starts_with("refuted") || cell.starts_with("outside") || cell.starts_with("lives"))
        return in_colour(cell, red);
    if (cell.starts_with("undecided")) return in_colour(cell, yellow);
    return cell;
}

Paint paint(const TableStyle& style) {
    return style.colour ? paint_outcome : nullptr;
}
std::size_t columns(const TableStyle& style) {
    return static_cast<std::size_t>(std::max(style.width, 0));
}

std::string living_mutants(const Results& results, const TableStyle& style) {
    std::vector<std::vector<std::string>> rows;
    for (const MutantResult& mutant : results.mutants)
        if (!mutant.killed) rows.push_back({"lives", mutant.id, to_string(mutant.verdict.outcome), mutant.defect});
    if (rows.empty()) return "";
    return "\n" + table({{"mutant"}, {"id"}, {"its claim"}, {"defect"}}, rows, columns(style), paint(style));
}

std::string seconds_text(double seconds) {
    return fmt::format("{:.2f}", seconds);
}

/// Whether the fitted slope's interval meets the expected one, in words.
std::string against_expectation(const Series& series) {
    if (!series.slope.doubt.empty()) return series.slope.doubt;
    if (!series.expected_slope) return "nothing expected";
    return fmt::format("{} the expected {}", meets_expectation(series).value_or(true) ? "meets" : "outside",
                       expected_text(series));
}

std::string series_table(const Series& series, const TableStyle& style) {
    std::vector<std::vector<std::string>> rows;
    for (const ConvergencePoint& p : series.points)
        rows.push_back({std::to_string(p.n), fmt::format("{:.6g}", p.evaluations), readable(p.seconds), readable(p.mse),
                        fmt::format("[{}, {}]", readable(p.mse_interval.low), readable(p.mse_interval.high)),
                        fmt::format("{} ± {}", readable(p.bias), readable(p.bias_standard_error))});
    const std::string head =
        fmt::format("{} on {}, {} replicates\n", series.estimator, series.integrand, series.replicates);
    const std::string slope =
        fmt::format("slope {} [{}, {}], {}\n", readable(series.slope.value), readable(series.slope.interval.low),
                    readable(series.slope.interval.high), against_expectation(series));
    return head +
           table({{"n", Align::right},
                  {"evaluations", Align::right},
                  {"seconds", Align::right},
                  {"mse", Align::right},
                  {"95 %"},
                  {"bias ± standard error"}},
                 rows, columns(style)) +
           slope;
}

/// "all", "2/3", "2/3, unfinished"
std::string part_of_run(const RunInfo& run) {
    const std::string shard = run.shards == 1 ? "all" : fmt::format("{}/{}", run.shard, run.shards);
    return run.finished ? shard : shard + ", unfinished";
}

std::string list_of(std::string_view heading, const std::vector<std::string>& ids) {
    std::string text;
    for (const std::string& id : ids) text += fmt::format("{}  {}\n", heading, id);
    return text;
}

std::string text_of(const FieldValue& field) {
    struct {
        std::string operator()(double x) const { return readable(x); }
        std::string operator()(std::uint64_t x) const { return std::to_string(x); }
        std::string operator()(const std::string& x) const { return x; }
        std::string operator()(const std::vector<double>& list) const {
            std::string text;
            for (const double x : list) text += (text.empty() ? "" : ", ") + readable(x);
            return text;
        }
    } const write;
    return std::visit(write, field);
}

// On a terminal: without kind and seconds, and with ids in at most two fifths of the room that the numbers leave, since
// why a claim is refuted says more than the head of its id.
std::string narrow_verdicts(const Results& results, const TableStyle& style) {
    std::size_t widest = columns_of("deviation");
    for (const ClaimResult& claim : results.claims)
        widest = std::max(widest, columns_of(readable(claim.verdict.deviation)));
    const std::size_t numbers = columns_of("undecided") + widest + columns_of("samples") + 4 * 2;
    const std::size_t room = columns(style) > numbers ? columns(style) - numbers : 0;
    const std::size_t most = std::max<std::size_t>(room * 2 / 5, 16);
    std::vector<std::vector<std::string>> rows;
    for (const ClaimResult& claim : results.claims)
        rows.push_back({to_string(claim.verdict.outcome), shortened_from_left(claim.id, most),
                        readable(claim.verdict.deviation), readable_count(claim.verdict.samples),
                        claim.verdict.reason});
    return table({{"outcome"}, {"claim"}, {"deviation", Align::right}, {"samples", Align::right}, {"reason"}}, rows,
                 columns(style), paint(style));
}

std::string wide_verdicts(const Results& results, const TableStyle& style) {
    std::vector<std::vector<std::string>> rows;
    for (const ClaimResult& claim : results.claims)
        rows.push_back({to_string(claim.verdict.outcome), claim.id, to_string(claim.kind),
                        readable(claim.verdict.deviation), readable_count(claim.verdict.samples),
                        seconds_text(claim.seconds), claim.verdict.reason});
    return table({{"outcome"},
                  {"claim"},
                  {"kind"},
                  {"deviation", Align::right},
                  {"samples", Align::right},
                  {"seconds", Align::right},
                  {"reason"}},
                 rows, columns(style), paint(style));
}

}  // namespace

std::string verdict_table(const Results& results, const TableStyle& style) {
    const bool narrow = style.width < TableStyle::unlimited;
    return (narrow ? narrow_verdicts(results, style) : wide_verdicts(results, style)) + living_mutants(results, style) +
           "\n" + summary_line(results) + "\n";
}

std::string converge_table(std::span<const Series> series, const TableStyle& style) {
    std::string text;
    for (const Series& s : series) text += (text.empty() ? "" : "\n") + series_table(s, style);
    return text;
}

std::string differences_table(const Differences& differences, const TableStyle& style) {
    const std::string rest =
        differences.not_asked == 0
            ? ""
            : fmt::format("{} claims and mutants that only one of the runs was asked for are left out\n",
                          differences.not_asked);
    if (differences.empty()) return "no differences in outcomes\n" + rest;
    std::vector<std::vector<std::string>> rows;
    for (const auto* changes : {&differences.claims, &differences.mutants})
        for (const OutcomeChange& change : *changes)
            rows.push_back({change.id, to_string(change.before), to_string(change.after)});
    std::string text;
    if (!rows.empty()) text = table({{"changed"}, {"before"}, {"after"}}, rows, columns(style), paint(style));
    return text + list_of("added", differences.added) + list_of("removed", differences.removed) +
           list_of("added mutant", differences.added_mutants) + list_of("removed mutant", differences.removed_mutants) +
           rest;
}

std::string runs_table(std::span<const StoredRun> runs, const TableStyle& style) {
    std::vector<std::vector<std::string>> rows;
    for (const StoredRun& stored : runs)
        rows.push_back({std::to_string(stored.id), stored.run.started, stored.run.size, std::to_string(stored.run.seed),
                        std::to_string(stored.tally.holds), std::to_string(stored.tally.refuted),
                        std::to_string(stored.tally.undecided),
                        fmt::format("{} of {}", stored.tally.killed, stored.tally.mutants), part_of_run(stored.run),
                        stored.run.patterns});
    return table({{"run", Align::right},
                  {"started"},
                  {"size"},
                  {"seed", Align::right},
                  {"hold", Align::right},
                  {"refuted", Align::right},
                  {"undecided", Align::right},
                  {"mutants", Align::right},
                  {"part"},
                  {"patterns"}},
                 rows, columns(style));
}

std::string list_table(std::span<const ListRow> rows, const TableStyle& style) {
    if (rows.empty()) return "";
    std::vector<Column> headings;
    for (const auto& [name, value] : rows.front())
        headings.push_back({name, std::holds_alternative<std::string>(value) ? Align::left : Align::right});
    std::vector<std::vector<std::string>> cells;
    for (const ListRow& row : rows) {
        std::vector<std::string>& line = cells.emplace_back();
        for (std::size_t c = 0; c < headings.size(); ++c) {
            const std::string cell = c < row.size() ? text_of(row[c].second) : "";
            const bool shorten = style.width < TableStyle::unlimited && c > 0 && c + 1 < headings.size();
            line.push_back(shorten ? shortened(cell, 40) : cell);
        }
    }
    return table(headings, cells, columns(style));
}

}  // namespace plumb::reports
