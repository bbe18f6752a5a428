#include "reports/run/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/text/text.h"
#include "reports/text/xml.h"

namespace plumb::reports {
namespace {

struct Case {
    std::uint64_t position = 0;
    std::string group = {}, subject = {}, name = {};  ///< of the id; a mutant's own is part of the name
    double seconds = 0;
    std::string problem = {};  ///< failure or error; empty when all is well
    std::string type = {}, message = {}, details = {};
};

std::string details(std::string_view statement, std::string_view source, const Verdict& verdict) {
    return fmt::format("{}\n{}\n{} samples, p-value {}, deviation {}, resolution {}", statement, source,
                       verdict.samples, readable(verdict.p_value), readable(verdict.deviation),
                       readable(verdict.resolution));
}

Case named(const std::string& id, std::uint64_t position, double seconds) {
    const std::size_t first = id.find('/'), second = first == std::string::npos ? first : id.find('/', first + 1);
    Case one{.position = position, .group = id.substr(0, first), .seconds = seconds};
    one.subject = second == std::string::npos ? one.group : one.group + "." + id.substr(first + 1, second - first - 1);
    const std::size_t before_name = second == std::string::npos ? first : second;
    one.name = before_name == std::string::npos ? id : id.substr(before_name + 1);
    return one;
}

Case case_of(const ClaimResult& claim) {
    Case one = named(claim.id, claim.position, claim.seconds);
    const Outcome outcome = claim.verdict.outcome;
    if (outcome == Outcome::holds) return one;
    one.problem = outcome == Outcome::refuted ? "failure" : "error";
    one.type = to_string(outcome);
    one.message = claim.verdict.reason;
    one.details = details(claim.statement, claim.source, claim.verdict);
    return one;
}

Case case_of(const MutantResult& mutant) {
    Case one = named(mutant.id, mutant.position, mutant.seconds);
    if (mutant.killed) return one;
    one.problem = mutant.verdict.outcome == Outcome::holds ? "failure" : "error";
    one.type = "mutant " + to_string(mutant.verdict.outcome);
    one.message = "not refuted: " + mutant.verdict.reason;
    one.details = details(mutant.defect, "must be refuted by " + mutant.of, mutant.verdict);
    return one;
}

std::string counts(std::span<const Case> cases) {
    const auto having = [&](std::string_view problem) { return std::ranges::count(cases, problem, &Case::problem); };
    double seconds = 0;
    for (const Case& one : cases) seconds += one.seconds;
    return fmt::format(R"(tests="{}" failures="{}" errors="{}" time="{:.3f}")", cases.size(), having("failure"),
                       having("error"), seconds);
}

std::string xml_of(const Case& one) {
    const std::string head = fmt::format(R"(    <testcase classname="{}" name="{}" time="{:.3f}")",
                                         escaped(one.subject), escaped(one.name), one.seconds);
    if (one.problem.empty()) return head + "/>\n";
    return fmt::format("{}>\n      <{} type=\"{}\" message=\"{}\">{}</{}>\n    </testcase>\n", head, one.problem,
                       escaped(one.type), escaped(one.message), escaped(one.details), one.problem);
}

std::string xml_of(const RunInfo& run) {
    const auto property = [](std::string_view name, const auto& value) {
        return fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, escaped(fmt::format("{}", value)));
    };
    return "    <properties>\n" + property("seed", run.seed) + property("alpha", run.alpha) +
           property("size", run.size) + property("version", run.version) +
           property("shard", fmt::format("{}/{}", run.shard, run.shards)) + "    </properties>\n";
}

}  // namespace

std::string junit_xml(const Results& results) {
    std::vector<Case> cases;
    for (const ClaimResult& claim : results.claims) cases.push_back(case_of(claim));
    for (const MutantResult& mutant : results.mutants) cases.push_back(case_of(mutant));
    std::vector<std::string> groups;  // in catalogue order
    std::ranges::stable_sort(cases, {}, &Case::position);
    for (const Case& one : cases)
        if (std::ranges::find(groups, one.group) == groups.end()) groups.push_back(one.group);

    const std::string when = results.run.started.substr(0, results.run.started.find('Z'));  // the schema knows no zone
    std::string xml =
        fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"plumb\" {}>\n", counts(cases));
    for (const std::string& group : groups) {
        std::vector<Case> members;
        std::ranges::copy_if(cases, std::back_inserter(members), [&](const Case& one) { return one.group == group; });
        xml += fmt::format("  <testsuite name=\"{}\" {} skipped=\"0\" timestamp=\"{}\">\n", escaped(group),
                           counts(members), when);
        xml += xml_of(results.run);
        for (const Case& one : members) xml += xml_of(one);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace plumb::reports
