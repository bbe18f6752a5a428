#include "reports/images/known_values.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/text/json_values.h"
#include "reports/text/text.h"

namespace plumb::reports {
namespace {

using json_values::Json, json_values::number;

std::string words(TileState state) {
    if (state == TileState::same) return "holds";
    return state == TileState::differs ? "refuted" : "undecided: " + to_string(state);
}

Outcome outcome_of(TileState state) {
    if (state == TileState::same) return Outcome::holds;
    return state == TileState::differs ? Outcome::refuted : Outcome::undecided;
}

// What a test of a difference says, behind what it is a test of.
Json with_test(Json json, const MeanDifference& found) {
    json["standard_error"] = number(found.standard_error);
    json["degrees"] = number(found.degrees);
    json["skewness"] = number(found.skewness);
    json["p_value"] = number(found.p_value);
    json["delta"] = number(found.delta);
    json["more_samples"] = number(found.more_samples);
    json["low"] = number(found.interval.low);
    json["high"] = number(found.interval.high);
    return json;
}

Json to(const CheckedTogether& together, const ValuesReport& report) {
    const MeanDifference& found = together.found;
    return with_test({{"channel", report.picture.channels[together.channel]},
                      {"values", together.values},
                      {"outcome", to_string(outcome_of(together.state))},
                      {"state", to_string(together.state)},
                      {"found", number(found.a)},
                      {"known", number(found.b)}},
                     found);
}

Json to(const CheckedValue& value, const ValuesReport& report) {
    const KnownValue& known = report.known[value.known];
    const MeanDifference& found = value.found;
    Json json = with_test({{"name", known.name},
                           {"x", known.x},
                           {"y", known.y},
                           {"width", known.width},
                           {"height", known.height},
                           {"channel", report.picture.channels[value.channel]},
                           {"outcome", to_string(outcome_of(value.state))},
                           {"state", to_string(value.state)},
                           {"found", number(found.a)},
                           {"known", number(known.value[value.channel])},
                           {"known_error", number(known.error)}},
                          found);
    json["source"] = known.source;
    return json;
}

}  // namespace

std::string values_json(const ValuesReport& report) {
    Json values = Json::array();
    for (const CheckedValue& value : report.check.values) values.push_back(to(value, report));
    Json together = Json::array();
    for (const CheckedTogether& test : report.check.together) together.push_back(to(test, report));
    const CheckSettings& s = report.settings;
    const Json json = {{"outcome", to_string(report.check.verdict.outcome)},
                       {"reason", report.check.verdict.reason},
                       {"files", report.files},
                       {"expected", report.expected},
                       {"settings", {{"alpha", s.alpha}, {"beta", s.beta}, {"delta", s.delta}}},
                       {"values", std::move(values)},
                       {"together", std::move(together)}};
    return json.dump(2) + "\n";
}

std::string values_table(const ValuesReport& report, const TableStyle& style) {
    std::vector<std::vector<std::string>> rows;
    for (const CheckedValue& value : report.check.values) {
        const MeanDifference& found = value.found;
        const double known = report.known[value.known].value[value.channel];
        const double off = 100 * found.difference / std::abs(known);
        rows.push_back({report.known[value.known].name, report.picture.channels[value.channel], readable(found.a),
                        readable(found.standard_error), readable(known), readable(known == 0 ? NAN : off),
                        words(value.state)});
    }
    for (const CheckedTogether& together : report.check.together) {
        const MeanDifference& found = together.found;
        rows.push_back({fmt::format("all {} together", together.values), report.picture.channels[together.channel],
                        readable(found.a), readable(found.standard_error), readable(found.b),
                        readable(100 * found.difference), words(together.state)});
    }
    return table({{"known at"},
                  {"channel"},
                  {"found", Align::right},
                  {"s.e.", Align::right},
                  {"known", Align::right},
                  {"off by %", Align::right},
                  {"verdict"}},
                 rows, static_cast<std::size_t>(style.width));
}

}  // namespace plumb::reports
