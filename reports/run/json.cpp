#include "reports/run/json.h"

#include <array>
#include <cmath>

#include "core/error.h"
#include "core/named.h"
#include "reports/run/json_document.h"

namespace plumb::reports {
namespace {

using json_values::Json, json_values::interval, json_values::number, json_values::text_of;

// ---- numbers and intervals

double number_from(const Json& json) {
    if (json.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (json.is_number()) return json.get<double>();
    const auto text = json.get<std::string>();
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
    throw Error(fmt::format("a number, null, \"inf\" or \"-inf\" was expected, not \"{}\"", text));
}

Interval interval_from(const Json& json) {
    return {number_from(json.at("low")), number_from(json.at("high"))};
}

Kind kind_from(std::string_view text) {
    static constexpr std::array kinds{Kind::exact, Kind::bounded, Kind::distribution, Kind::mean,
                                      Kind::ratio, Kind::rate,    Kind::cost};
    return find_named(kinds, text, "kind", [](Kind kind) { return to_string(kind); });
}

// ---- evidence

Json value(const FieldValue& field) {
    struct {
        Json operator()(double x) const { return number(x); }
        Json operator()(std::uint64_t x) const { return x; }
        Json operator()(const std::string& x) const { return x; }
        Json operator()(const std::vector<double>& list) const {
            Json json = Json::array();
            for (const double x : list) json.push_back(number(x));
            return json;
        }
    } const write;
    return std::visit(write, field);
}

FieldValue value_from(const Json& json) {
    if (json.is_number_unsigned()) return json.get<std::uint64_t>();
    if (json.is_array()) {
        std::vector<double> list;
        for (const Json& x : json) list.push_back(number_from(x));
        return list;
    }
    if (json.is_string() && json != "inf" && json != "-inf") return json.get<std::string>();
    return number_from(json);
}

Json fields(const std::vector<Field>& list) {
    Json json = Json::object();
    for (const auto& [name, field] : list) json[name] = value(field);
    return json;
}

Json objects(std::span<const ListRow> rows) {
    Json json = Json::array();
    for (const ListRow& row : rows) json.push_back(fields(row));
    return json;
}

std::vector<Field> fields_from(const Json& json) {
    std::vector<Field> list;
    for (const auto& [name, field] : json.items()) list.emplace_back(name, value_from(field));
    return list;
}

// ---- series and stability

Json to(const Slope& slope) {
    return {{"value", number(slope.value)},
            {"low", number(slope.interval.low)},
            {"high", number(slope.interval.high)},
            {"standard_error", number(slope.standard_error)},
            {"doubt", slope.doubt}};
}

Json to(const ConvergencePoint& p) {
    return {{"n", p.n},
            {"evaluations", number(p.evaluations)},
            {"seconds", number(p.seconds)},
            {"mse", number(p.mse)},
            {"mse_low", number(p.mse_interval.low)},
            {"mse_high", number(p.mse_interval.high)},
            {"bias", number(p.bias)},
            {"bias_standard_error", number(p.bias_standard_error)},
            {"log_mse_error", number(p.log_mse_error)}};
}

Json to(const Series& s) {
    Json points = Json::array();
    for (const ConvergencePoint& point : s.points) points.push_back(to(point));
    return {{"estimator", s.estimator},
            {"integrand", s.integrand},
            {"replicates", s.replicates},
            {"points", std::move(points)},
            {"slope", to(s.slope)},
            {"expected_slope", s.expected_slope ? interval(*s.expected_slope) : Json(nullptr)}};
}

Series series_of(const Json& json) {
    Series s;
    s.estimator = json.at("estimator");
    s.integrand = json.at("integrand");
    s.replicates = json.at("replicates");
    for (const Json& p : json.at("points"))
        s.points.push_back({.n = p.at("n"),
                            .evaluations = number_from(p.at("evaluations")),
                            .seconds = number_from(p.at("seconds")),
                            .mse = number_from(p.at("mse")),
                            .mse_interval = {number_from(p.at("mse_low")), number_from(p.at("mse_high"))},
                            .bias = number_from(p.at("bias")),
                            .bias_standard_error = number_from(p.at("bias_standard_error")),
                            .log_mse_error = number_from(p.at("log_mse_error"))});
    const Json& slope = json.at("slope");
    s.slope = {number_from(slope.at("value")), number_from(slope.at("standard_error")), interval_from(slope),
               slope.value("doubt", "")};
    if (!json.at("expected_slope").is_null()) s.expected_slope = interval_from(json.at("expected_slope"));
    return s;
}

Json to(const Stability& s) {
    Json points = Json::array();
    for (const StabilityPoint& p : s.points)
        points.push_back({{"case", p.hard_case}, {"x", number(p.x)}, {"relative_error", number(p.relative_error)}});
    return {{"formula", s.formula}, {"axis", s.axis}, {"unit", s.unit}, {"bound", number(s.bound)}, {"points", points}};
}

Stability stability_of(const Json& json) {
    Stability s{json.at("formula"), json.at("axis"), json.at("unit"), number_from(json.at("bound")), {}};
    for (const Json& p : json.at("points"))
        s.points.push_back({p.at("case"), number_from(p.at("x")), number_from(p.at("relative_error"))});
    return s;
}

Json to(const ClaimResult& claim);
Json to(const MutantResult& mutant);
Json to(const ErratumEntry& erratum);

template <class T>
Json list(std::span<const T> items) {
    Json json = Json::array();
    for (const T& item : items) json.push_back(to(item));
    return json;
}

// ---- verdicts, claims, mutants: a verdict's keys stand among those of the claim or mutant it belongs to

void put(Json& json, const Verdict& v) {
    json["outcome"] = to_string(v.outcome);
    json["samples"] = v.samples;
    json["statistic"] = number(v.statistic);
    json["p_value"] = number(v.p_value);
    json["deviation"] = interval(v.deviation);
    json["resolution"] = number(v.resolution);
    json["reason"] = v.reason;
    json["evidence"] = fields(v.evidence);
    if (!v.series.empty()) json["series"] = list<Series>(v.series);
    if (!v.stability.empty()) json["stability"] = list<Stability>(v.stability);
}

Verdict verdict_of(const Json& json) {
    Verdict v{.outcome = outcome_from(json.at("outcome").get<std::string>()),
              .statistic = number_from(json.at("statistic")),
              .p_value = number_from(json.at("p_value")),
              .deviation = interval_from(json.at("deviation")),
              .resolution = number_from(json.at("resolution")),
              .samples = json.at("samples"),
              .reason = json.at("reason"),
              .evidence = fields_from(json.at("evidence")),
              .series = {},
              .stability = {}};
    for (const Json& series : json.value("series", Json::array())) v.series.push_back(series_of(series));
    for (const Json& stability : json.value("stability", Json::array())) v.stability.push_back(stability_of(stability));
    return v;
}

Json to(const ClaimResult& claim) {
    Json json = {{"id", claim.id},
                 {"statement", claim.statement},
                 {"source", claim.source},
                 {"kind", to_string(claim.kind)},
                 {"alpha_share", number(claim.alpha_share)},
                 {"seconds", number(claim.seconds)},
                 {"no_mutant", claim.no_mutant}};
    put(json, claim.verdict);
    return json;
}

ClaimResult claim_of(const Json& json) {
    return {.id = json.at("id"),
            .statement = json.at("statement"),
            .source = json.at("source"),
            .kind = kind_from(json.at("kind").get<std::string>()),
            .verdict = verdict_of(json),
            .alpha_share = number_from(json.at("alpha_share")),
            .seconds = number_from(json.at("seconds")),
            .no_mutant = json.at("no_mutant")};
}

Json to(const MutantResult& mutant) {
    Json json = {{"id", mutant.id},
                 {"of", mutant.of},
                 {"defect", mutant.defect},
                 {"killed", mutant.killed},
                 {"seconds", number(mutant.seconds)}};
    put(json, mutant.verdict);
    return json;
}

MutantResult mutant_of(const Json& json) {
    return {.id = json.at("id"),
            .of = json.at("of"),
            .defect = json.at("defect"),
            .verdict = verdict_of(json),
            .killed = json.at("killed"),
            .seconds = number_from(json.at("seconds"))};
}

Json to(const ErratumEntry& e) {
    return {{"source", e.source}, {"printed", e.printed}, {"correct", e.correct}, {"claim", e.claim}};
}

Json to(const RunInfo& run) {
    return {{"seed", run.seed},
            {"alpha", number(run.alpha)},
            {"threads", run.threads},
            {"size", run.size},
            {"version", run.version},
            {"started", run.started},
            {"patterns", run.patterns},
            {"shard", run.shard},
            {"shards", run.shards},
            {"selected", run.selected},
            {"fingerprint", run.fingerprint},
            {"finished", run.finished},
            {"seconds", number(run.seconds)}};
}

RunInfo run_of(const Json& json) {
    return {.seed = json.at("seed"),
            .alpha = number_from(json.at("alpha")),
            .threads = json.at("threads"),
            .size = json.at("size"),
            .version = json.at("version"),
            .started = json.at("started"),
            .patterns = json.at("patterns"),
            .shard = json.at("shard"),
            .shards = json.at("shards"),
            .selected = json.at("selected"),
            .fingerprint = json.at("fingerprint"),
            .finished = json.at("finished"),
            .seconds = number_from(json.at("seconds"))};
}

Results results_of(const Json& json) {
    Results results{.run = run_of(json.at("run"))};
    for (const Json& claim : json.at("claims")) results.claims.push_back(claim_of(claim));
    for (const Json& mutant : json.at("mutants")) results.mutants.push_back(mutant_of(mutant));
    for (const Json& e : json.at("errata"))
        results.errata.push_back({e.at("source"), e.at("printed"), e.at("correct"), e.at("claim")});
    for (const Json& series : json.at("series")) results.series.push_back(series_of(series));
    return results;
}

// ---- text

template <class F>
auto parsed(std::string_view text, std::string_view name, std::string_view what, const F& read) {
    try {
        return read(Json::parse(text));
    } catch (const Error& error) {
        throw Error(fmt::format("{}: not {}: {}", name, what, error.what()));
    } catch (const Json::exception& error) {
        throw Error(fmt::format("{}: not {}: {}", name, what, error.what()));
    }
}

}  // namespace

Json json_document(const Results& results) {
    return {{"run", to(results.run)},
            {"claims", list<ClaimResult>(results.claims)},
            {"mutants", list<MutantResult>(results.mutants)},
            {"errata", list<ErratumEntry>(results.errata)},
            {"series", list<Series>(results.series)}};
}

std::string to_json(const Results& results) {
    return text_of(json_document(results), 2) + "\n";
}

Results results_from_json(std::string_view text, std::string_view name) {
    return parsed(text, name, "the JSON of a run", results_of);
}

std::string converge_json(const RunInfo& run, std::span<const Series> series, std::span<const std::string> truths) {
    return text_of({{"run", to(run)}, {"series", list(series)}, {"truths", truths}}, 2) + "\n";
}

std::string integration_json(const RunInfo& run, std::span<const ListRow> answers, std::span<const Series> series) {
    return text_of({{"run", to(run)}, {"answers", objects(answers)}, {"series", list(series)}}, 2) + "\n";
}

std::string list_json(std::span<const ListRow> rows) {
    return text_of(objects(rows), 2) + "\n";
}

std::string claim_json(const ClaimResult& claim) {
    return text_of(to(claim));
}
std::string mutant_json(const MutantResult& mutant) {
    return text_of(to(mutant));
}
std::string series_json(const Series& series) {
    return text_of(to(series));
}

ClaimResult claim_from_json(std::string_view text, std::string_view name) {
    return parsed(text, name, "the JSON of a claim", claim_of);
}

MutantResult mutant_from_json(std::string_view text, std::string_view name) {
    return parsed(text, name, "the JSON of a mutant", mutant_of);
}

Series series_from_json(std::string_view text, std::string_view name) {
    return parsed(text, name, "the JSON of a series", series_of);
}

}  // namespace plumb::reports
