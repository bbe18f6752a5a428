#include "cli/verbs/outputs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/session.h"
#include "core/error.h"
#include "core/file.h"
#include "reports/run/html.h"
#include "reports/run/json.h"
#include "reports/run/junit.h"
#include "reports/run/table.h"

namespace plumb::cli {
namespace {

std::filesystem::path real_path(const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
}

int exit_code(const reports::Results& results) {
    const auto claims = [&](Outcome outcome) {
        return std::ranges::any_of(results.claims,
                                   [&](const reports::ClaimResult& c) { return c.verdict.outcome == outcome; });
    };
    const auto mutants = [&](Outcome outcome) {
        return std::ranges::any_of(results.mutants,
                                   [&](const reports::MutantResult& m) { return m.verdict.outcome == outcome; });
    };
    if (claims(Outcome::refuted) || mutants(Outcome::holds)) return 1;
    if (claims(Outcome::undecided) || mutants(Outcome::undecided)) return 3;
    return 0;
}

}  // namespace

void add_outputs(CLI::App& verb, Outputs& outputs) {
    verb.add_option("--json", outputs.json, "write verdicts as JSON to this file");
    verb.add_option("--junit", outputs.junit, "write verdicts as JUnit XML, for CI servers, to this file");
    verb.add_option("--report", outputs.report, "the HTML report; '' for none")->capture_default_str();
    verb.add_option("--store", outputs.store, "the SQLite store that the run is added to")->capture_default_str();
}

void check_outputs(const Outputs& outputs) {
    std::map<std::filesystem::path, std::string> taken = {{real_path(outputs.store), "--store"}};
    for (const auto& [option, file] : {std::pair("--json", outputs.json), std::pair("--junit", outputs.junit),
                                       std::pair("--report", outputs.report)}) {
        if (file.empty()) continue;
        require_writable({file});
        const auto [other, is_new] = taken.emplace(real_path(file), option);
        if (!is_new)
            throw Error(
                fmt::format("{}: named by {} and {}; each needs a file of its own", file, other->second, option));
    }
}

int publish(const reports::Results& results, std::int64_t run, const Outputs& outputs) {
    if (!outputs.json.empty()) write_output(outputs.json, reports::to_json(results));
    if (!outputs.junit.empty()) write_output(outputs.junit, reports::junit_xml(results));
    if (!outputs.report.empty()) write_output(outputs.report, reports::report_html(results));
    fmt::print("{}", reports::verdict_table(results, terminal_style()));
    for (const reports::ClaimResult& claim : results.claims)  // what the table's width may have cut off
        if (claim.verdict.outcome != Outcome::holds) fmt::print("{}: {}\n", claim.id, describe(claim.verdict));
    fmt::print("run {} in {}, seed {}, {:.1f} s{}\n", run, outputs.store, results.run.seed, results.run.seconds,
               outputs.report.empty() ? "" : "; report: " + outputs.report);
    return exit_code(results);
}

}  // namespace plumb::cli
