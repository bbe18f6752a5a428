#include "studies/reproduction.h"

#include <algorithm>
#include <chrono>
#include <span>

#include <fmt/ranges.h>

#include "core/error.h"
#include "core/random.h"
#include "reports/run/merge.h"
#include "reports/run/planning.h"
#include "studies/measure.h"
#include "studies/shipped.h"
#include "studies/study_file.h"

namespace plumb {
namespace {

std::uint64_t replicates_of(const FigurePlan& plan, Size size) {
    if (size == Size::full) return plan.replicates;
    return std::min(plan.replicates, std::max<std::uint64_t>(100, plan.replicates / 10));
}

bool chosen(const FigureTask& task, const std::string& pattern) {
    return matches(task.study.about.name, pattern) || matches(task.id, pattern);
}

/// Of what was selected: runs of different figures must not be mixed.
std::string fingerprint(const std::vector<FigureTask>& tasks) {
    std::string all;
    for (const FigureTask& task : tasks) all += task.text + "\n";
    return fmt::format("{:016x}", stream_id(all));
}

void check_fingerprint(const std::vector<FigureTask>& tasks, const reports::RunInfo& run) {
    if (fingerprint(tasks) != run.fingerprint)
        throw Error(
            fmt::format("the studies have changed since the run with seed {} was begun; measure them anew", run.seed));
}

template <int D>
double integral_of(const std::string& id) {
    return find_integrand<D>(id).integral_value();
}

// A store keeps series, not the truth of a scene's panel: what is relative to it is not known there.
double integral_of(const std::string& id) {
    if (knows_integrand<1>(id)) return integral_of<1>(id);
    return knows_integrand<2>(id) ? integral_of<2>(id) : std::numeric_limits<double>::quiet_NaN();
}

reports::FigureResult figure_from(const FigurePlan& plan, const std::vector<Series>& series) {
    reports::FigureResult figure{plan.about, {}};
    for (const std::string& id : plan.integrands) {
        reports::FigurePanel& panel = figure.panels.emplace_back(
            reports::FigurePanel{.integrand = id, .integral = integral_of(id), .series = {}});
        if (!knows_integrand<1>(id) && !knows_integrand<2>(id)) panel.unit = "rays";  // a scene
        std::ranges::copy_if(series, std::back_inserter(panel.series),
                             [&](const Series& one) { return one.integrand == id; });
    }
    return figure;
}

std::vector<Series> all_series(const reports::FigureResult& figure) {
    std::vector<Series> series;
    for (const reports::FigurePanel& panel : figure.panels)
        series.insert(series.end(), panel.series.begin(), panel.series.end());
    return series;
}

/// The first so many of the series that a run has measured, taken away from them.
std::vector<Series> next_series(std::span<const Series>& left, std::size_t count) {
    const std::span<const Series> taken = left.first(count);
    left = left.subspan(count);
    return {taken.begin(), taken.end()};
}

/// How many of these figures, which are measured one after the other, a run with so many series has.
std::size_t measured_figures(const std::vector<FigureTask>& tasks, std::size_t series) {
    std::size_t figures = 0;
    for (; figures < tasks.size() && tasks[figures].size() <= series; ++figures) series -= tasks[figures].size();
    return figures;
}

std::string figure_id(const std::string& study, const std::string& figure) {
    return study + "-" + figure;
}

/// Adds the study's headlines and figures to the whole, under ids that say the study.
void add_study(const Study& study, std::vector<reports::FigureResult> figures, reports::StudyResult& whole) {
    for (reports::Headline& headline : measure_headlines(study, figures)) {
        if (!headline.figure.empty()) headline.figure = figure_id(study.about.name, headline.figure);
        whole.headlines.push_back(std::move(headline));
    }
    for (reports::FigureResult& figure : figures) {
        figure.about.id = figure_id(study.about.name, figure.about.id);
        figure.about.title = study.about.title + ": " + figure.about.title;
        whole.figures.push_back(std::move(figure));
    }
}

reports::StudyText about(const reports::RunInfo& run, const std::vector<std::string>& missing) {
    std::string text =
        fmt::format("Statements of papers, and what the estimators that come with Plumb say of them: {}.",
                    run.size == "full" ? "the full size, with the replicates that each study asks for"
                                       : "the quick size, with a tenth of the replicates of each study");
    if (!missing.empty()) text += fmt::format("\n\nFigures that are not measured: {}.", fmt::join(missing, ", "));
    return {.name = "reproduce", .title = "What papers promise", .text = text, .source = "", .several = true};
}

}  // namespace

std::vector<FigureTask> figure_tasks(const std::vector<std::pair<std::string, std::string>>& names_and_texts, Size size,
                                     const std::vector<std::string>& patterns) {
    std::vector<FigureTask> tasks;
    for (const auto& [name, text] : names_and_texts) {
        const Study study = parse_study(text, name + ".toml");
        for (FigurePlan plan : study.figures) {
            if (std::ranges::find(study.headlines, plan.about.id, &HeadlinePlan::figure) == study.headlines.end())
                continue;
            plan.replicates = replicates_of(plan, size);
            const std::string id = name + "/" + plan.about.id;
            tasks.push_back({study, plan, id, 0, fmt::format("{} {} {}", id, plan.replicates, text)});
        }
    }
    for (const std::string& pattern : patterns)
        if (std::ranges::none_of(tasks, [&](const FigureTask& task) { return chosen(task, pattern); }))
            throw Error(fmt::format("no study or figure with headlines matches '{}'", pattern));
    std::erase_if(tasks, [&](const FigureTask& task) {
        return !patterns.empty() &&
               std::ranges::none_of(patterns, [&](const std::string& pattern) { return chosen(task, pattern); });
    });
    for (std::size_t i = 1; i < tasks.size(); ++i) tasks[i].position = tasks[i - 1].position + tasks[i - 1].size();
    return tasks;
}

std::vector<FigureTask> shipped_figure_tasks(Size size, const std::vector<std::string>& patterns) {
    std::vector<std::pair<std::string, std::string>> studies;
    for (const auto& [name, text] : shipped_studies()) studies.emplace_back(name, text);
    return figure_tasks(studies, size, patterns);
}

std::vector<FigureTask> shipped_tasks_of(const reports::RunInfo& run) {
    return shipped_figure_tasks(reports::size_of(run), reports::patterns_of(run));
}

std::vector<FigureTask> tasks_of_shard(const std::vector<FigureTask>& tasks, const Shard& shard) {
    std::vector<FigureTask> ours;
    const auto step = static_cast<std::size_t>(shard.count);
    for (std::size_t i = static_cast<std::size_t>(shard.index) - 1; i < tasks.size(); i += step)
        ours.push_back(tasks[i]);
    return ours;
}

ReproductionPlan begin_reproduction(std::vector<FigureTask> tasks, reports::RunInfo run, reports::Store& store) {
    run.selected = tasks.size();
    run.fingerprint = fingerprint(tasks);
    const std::int64_t number = store.begin(run, {});
    return {std::move(run), number, std::move(tasks)};
}

ReproductionPlan resume_reproduction(const TasksOf& tasks_of, const reports::Store& store, const std::string& file) {
    const reports::StoredRun stored = reports::newest_unfinished(store, file, false);
    ReproductionPlan plan{stored.run, stored.id, tasks_of(stored.run)};
    check_fingerprint(plan.tasks, plan.run);
    plan.done = measured_figures(tasks_of_shard(plan.tasks, {plan.run.shard, plan.run.shards}),
                                 store.load(plan.number).series.size());
    return plan;
}

void measure_left(ReproductionPlan& plan, reports::Store& store, const std::stop_token& stop,
                  const std::function<void(const std::string&)>& progress) {
    using clock = std::chrono::steady_clock;
    const auto start = clock::now();
    const double before = plan.run.seconds;
    const std::vector<FigureTask> ours = tasks_of_shard(plan.tasks, {plan.run.shard, plan.run.shards});
    for (; plan.done < ours.size(); ++plan.done) {
        const FigureTask& task = ours[plan.done];
        const auto tell = [&](const std::string& what) {
            progress(fmt::format("{}/{} {}: {}", plan.done + 1, ours.size(), task.study.about.name, what));
        };
        const reports::FigureResult figure =
            measure_figure(task.study, task.plan, Run(plan.run.seed, "study", 1), tell);
        if (stop.stop_requested()) return;
        plan.run.seconds = before + std::chrono::duration<double>(clock::now() - start).count();
        store.add(plan.number, task.position, all_series(figure), plan.run.seconds);
    }
    store.finish(plan.number);
}

reports::Results join_figures(const TasksOf& tasks_of, const std::vector<reports::Results>& shards) {
    reports::Results joined{.run = reports::joined_run(shards)};
    const std::vector<FigureTask> tasks = tasks_of(joined.run);
    check_fingerprint(tasks, joined.run);
    std::vector<std::span<const Series>> left;
    for (const reports::Results& shard : shards) left.emplace_back(shard.series);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        std::span<const Series>& of_shard = left[i % left.size()];
        if (of_shard.size() < tasks[i].size())
            throw Error(fmt::format("the shard of {} lacks series: its store is damaged", tasks[i].id));
        std::ranges::move(next_series(of_shard, tasks[i].size()), std::back_inserter(joined.series));
    }
    return joined;
}

Reproduction gather(const std::vector<FigureTask>& tasks, const reports::Results& stored) {
    const reports::RunInfo& run = stored.run;
    const auto step = static_cast<std::size_t>(run.shards), first = static_cast<std::size_t>(run.shard) - 1;
    Reproduction whole{{.run = run, .about = {}, .figures = {}, .headlines = {}}, {}};
    std::span<const Series> left = stored.series;
    for (std::size_t i = 0; i < tasks.size();) {
        const Study& study = tasks[i].study;
        std::vector<reports::FigureResult> figures;
        for (; i < tasks.size() && tasks[i].study.about.name == study.about.name; ++i)
            if (i % step == first && left.size() >= tasks[i].size())
                figures.push_back(figure_from(tasks[i].plan, next_series(left, tasks[i].size())));
            else
                whole.missing.push_back(tasks[i].id);
        add_study(study, std::move(figures), whole.result);
    }
    whole.result.about = about(run, whole.missing);
    return whole;
}

}  // namespace plumb
