#include "studies/headline_file.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "core/named.h"

namespace plumb {
namespace {

const std::vector<std::string> texts = {"source", "place", "states", "quotes", "remark"};

const FigurePlan& figure_of(const Study& study, const Section& section) {
    const auto id_of = [](const FigurePlan& figure) -> std::string_view { return figure.about.id; };
    return *section.read(
        "figure", [&](const auto&) { return &find_named(study.figures, section.text("figure"), "figure", id_of); });
}

/// A name that the figure lists.
std::string listed(const Section& section, const char* key, const std::vector<std::string>& names) {
    const std::string name = section.text(key);
    if (std::ranges::find(names, name) == names.end())
        section.fail(key, fmt::format("'{}' is not in the figure; accepted are {}", name, fmt::join(names, ", ")));
    return name;
}

/// One count of the figure, or two: from, to. Without the key its last one, or its first and last.
void read_counts(const Section& section, const FigurePlan& figure, HeadlinePlan& plan) {
    std::vector<std::uint64_t> counts = figure.budget.counts;
    std::ranges::sort(counts);
    const bool range = measures_a_range(plan.measure);
    plan.from = range ? counts.front() : counts.back();
    plan.to = counts.back();
    plan.in_evaluations = figure.budget.unit == Budget::Unit::evaluations;
    const char* const key = range ? "over" : "at";
    if (!section.has(key)) return;
    const std::vector<std::uint64_t> given = section.list<std::int64_t>(key, "a count", [&](std::int64_t n) {
        if (n < 0 || !std::ranges::binary_search(counts, static_cast<std::uint64_t>(n)))
            throw Error(fmt::format("{} is no count of the figure; accepted are {}", n, fmt::join(counts, ", ")));
        return static_cast<std::uint64_t>(n);
    });
    if (given.size() != (range ? 2U : 1U) || given.front() > given.back())
        section.fail(key, range ? "accepted are two counts, from and to" : "accepted is one count");
    plan.from = given.front();
    plan.to = given.back();
}

Interval read_bound(const Section& section) {
    std::vector<const char*> given;
    for (const char* const key : {"at_most", "at_least", "between"})
        if (section.has(key)) given.push_back(key);
    if (given.size() != 1)
        section.fail(given.empty() ? "at_most" : given[1],
                     given.empty() ? "is missing; it, at_least or between says what is stated as a number"
                                   : fmt::format("stands beside {}; one of them is accepted", given[0]));
    const std::string key = given[0];
    const std::vector<double> numbers = section.numbers(key);
    if (!std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
        section.fail(key, "finite numbers are accepted");
    if (key == "between") {
        if (numbers.size() != 2 || numbers[0] > numbers[1]) section.fail(key, "accepted are two numbers, low and high");
        return {numbers[0], numbers[1]};
    }
    if (numbers.size() != 1) section.fail(key, "accepted is one number");
    return key == "at_most" ? Interval{.high = numbers[0]} : Interval{.low = numbers[0]};
}

void read_measure(const Study& study, const Section& section, HeadlinePlan& plan) {
    const FigurePlan& figure = figure_of(study, section);
    plan.figure = figure.about.id;
    plan.measure = section.text("measure");
    section.read("measure", [&](const auto&) { return measures_against(plan.measure); });
    plan.estimator = listed(section, "estimator", figure.estimators);
    if (section.has("against") && !measures_against(plan.measure))
        section.fail("against", fmt::format("a {} stands for itself", plan.measure));
    if (section.has("against")) plan.against = listed(section, "against", figure.estimators);
    const bool one = figure.integrands.size() == 1 && !section.has("integrand");
    plan.integrand = one ? figure.integrands.front() : listed(section, "integrand", figure.integrands);
    read_counts(section, figure, plan);
    plan.stated = read_bound(section);
}

/// The statement: `quotes` has the source's own words, `states` ours.
void read_statement(const Section& section, HeadlinePlan& plan) {
    plan.quoted = section.has("quotes");
    if (plan.quoted && section.has("states")) section.fail("states", "stands beside quotes; one of them is accepted");
    plan.states = section.text(plan.quoted ? "quotes" : "states");
}

}  // namespace

HeadlinePlan read_headline(const Study& study, const toml::table& table, const std::string& file) {
    std::vector<std::string> accepted = texts;
    const std::vector<std::string> rest =
        table.contains("not_comparable")
            ? std::vector<std::string>{"not_comparable"}
            : std::vector<std::string>{"figure", "measure", "estimator", "against", "integrand",     "at",
                                       "over",   "at_most", "at_least",  "between", "not_comparable"};
    accepted.insert(accepted.end(), rest.begin(), rest.end());
    const Section section(table, "headline", file, accepted);
    HeadlinePlan plan;
    plan.source = section.text("source", study.about.source);
    plan.place = section.text("place");
    read_statement(section, plan);
    plan.remark = section.text("remark", "");
    if (section.has("not_comparable"))
        plan.not_comparable = section.text("not_comparable");
    else
        read_measure(study, section, plan);
    return plan;
}

}  // namespace plumb
