#include "studies/reproduction.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/error.h"
#include "core/random.h"
#include "reports/run/store.h"
#include "studies/measure.h"
#include "studies/shipped.h"
#include "studies/study_file.h"

namespace plumb {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view prefix = "reproduce ";  // of the patterns of our runs in a store

std::uint64_t replicates_of(const FigurePlan& plan, Size size) {
    if (size == Size::full) return plan.replicates;
    return std::min(plan.replicates, std::max<std::uint64_t>(100, plan.replicates / 10));
}

bool chosen(const FigureTask& task, const std::string& pattern) {
    return matches(task.study.about.name, pattern) || matches(task.id, pattern);
}

/// Whether a stored run holds the figure of this task, for this seed and size.
bool holds(const reports::RunInfo& stored, const FigureTask& task, const reports::RunInfo& run) {
    return stored.fingerprint == task.fingerprint && stored.seed == run.seed && stored.size == run.size &&
           stored.version == run.version && stored.finished;
}

bool is_reproduction(const reports::StoredRun& stored) {
    return stored.run.patterns.starts_with(prefix);
}

/// The series of the tasks that the stores have, by fingerprint.
std::map<std::string, std::vector<Series>> series_in(const std::vector<Path>& stores,
                                                     const std::vector<FigureTask>& tasks,
                                                     const reports::RunInfo& run) {
    std::map<std::string, std::vector<Series>> found;
    for (const Path& file : stores) {
        const reports::Store store(file, reports::Store::Access::read);
        for (const reports::StoredRun& stored : store.runs())
            for (const FigureTask& task : tasks)
                if (holds(stored.run, task, run) && !found.contains(task.fingerprint))
                    found[task.fingerprint] = store.load(stored.id).series;
    }
    return found;
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

reports::StudyText about(const reports::RunInfo& run) {
    return {.name = "reproduce",
            .title = "What papers promise",
            .text = fmt::format("Statements of papers, and what the estimators that come with Plumb say of them: {}.",
                                run.size == "full" ? "the full size, with the replicates that each study asks for"
                                                   : "the quick size, with a tenth of the replicates of each study"),
            .source = ""};
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
            const std::string fingerprint =
                fmt::format("{:016x}", stream_id(fmt::format("{} {} {}", id, plan.replicates, text)));
            tasks.push_back({study, std::move(plan), id, fingerprint});
        }
    }
    for (const std::string& pattern : patterns)
        if (std::ranges::none_of(tasks, [&](const FigureTask& task) { return chosen(task, pattern); }))
            throw Error(fmt::format("no study or figure with headlines matches '{}'", pattern));
    std::erase_if(tasks, [&](const FigureTask& task) {
        return !patterns.empty() &&
               std::ranges::none_of(patterns, [&](const std::string& pattern) { return chosen(task, pattern); });
    });
    return tasks;
}

std::vector<FigureTask> shipped_figure_tasks(Size size, const std::vector<std::string>& patterns) {
    std::vector<std::pair<std::string, std::string>> studies;
    for (const auto& [name, text] : shipped_studies()) studies.emplace_back(name, text);
    return figure_tasks(studies, size, patterns);
}

void measure_missing(const std::vector<FigureTask>& tasks, const Shard& shard, const reports::RunInfo& run,
                     const Path& store, const std::vector<Path>& others,
                     const std::function<void(const std::string&)>& progress) {
    reports::Store kept(store, reports::Store::Access::append);
    std::vector<Path> stores = others;
    stores.push_back(store);
    const auto done = series_in(stores, tasks, run);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const FigureTask& task = tasks[i];
        const bool ours = static_cast<int>(i % static_cast<std::size_t>(shard.count)) == shard.index - 1;
        if (!ours || done.contains(task.fingerprint)) continue;
        const auto tell = [&](const std::string& what) { progress(task.study.about.name + ": " + what); };
        const reports::FigureResult figure = measure_figure(task.study, task.plan, Run(run.seed, "study", 1), tell);
        reports::Results results{.run = run, .series = all_series(figure)};
        results.run.patterns = std::string(prefix) + task.id;
        results.run.fingerprint = task.fingerprint;
        results.run.finished = true;
        kept.append(results);
    }
}

Reproduction gather(const std::vector<FigureTask>& tasks, const reports::RunInfo& run,
                    const std::vector<Path>& stores) {
    const auto found = series_in(stores, tasks, run);
    Reproduction whole{{.run = run, .about = about(run), .figures = {}, .headlines = {}}, {}};
    for (std::size_t i = 0; i < tasks.size();) {
        const Study& study = tasks[i].study;
        std::vector<reports::FigureResult> figures;
        for (; i < tasks.size() && tasks[i].study.about.name == study.about.name; ++i) {
            const auto series = found.find(tasks[i].fingerprint);
            if (series == found.end())
                whole.missing.push_back(tasks[i].id);
            else
                figures.push_back(figure_from(tasks[i].plan, series->second));
        }
        add_study(study, std::move(figures), whole.result);
    }
    return whole;
}

reports::RunInfo newest_reproduction(const Path& store) {
    const std::vector<reports::StoredRun> runs = reports::Store(store, reports::Store::Access::read).runs();
    const auto newest = std::find_if(runs.rbegin(), runs.rend(), is_reproduction);
    if (newest == runs.rend()) throw Error(fmt::format("{}: no reproduction is there to go on with", store.string()));
    return newest->run;
}

}  // namespace plumb
