#include "verification/runner.h"

#include <algorithm>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

std::vector<Judged> select(const Catalogue& catalogue, const RunSetting& setting) {
    for (const std::string& pattern : setting.patterns) {
        const auto selects = [&](const Claim& claim) {
            return belongs(claim, setting.size) && matches(claim.id, pattern);
        };
        if (std::ranges::any_of(catalogue.claims(), selects)) continue;
        std::vector<std::string> known;
        for (const Claim& claim : catalogue.claims())
            if (belongs(claim, setting.size)) known.push_back(claim.id);
        const std::string near = nearest_name(pattern, known);
        throw Error(fmt::format("no claim matches '{}'{}; `plumb list claims` shows them all", pattern,
                                near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
    }
    std::vector<Judged> selected;
    for (const Claim& claim : catalogue.claims()) {
        const auto wanted = [&](const std::string& pattern) { return matches(claim.id, pattern); };
        if (!belongs(claim, setting.size)) continue;
        if (!setting.patterns.empty() && std::ranges::none_of(setting.patterns, wanted)) continue;
        selected.push_back({.claim = &claim});
        for (const Mutant& mutant : claim.mutants) selected.push_back({.claim = &claim, .mutant = &mutant});
    }
    return selected;
}

Verdict guarded(const Check& check, const Run& run) {
    try {
        return check(run);
    } catch (const std::exception& failure) {
        Verdict verdict;
        verdict.reason = fmt::format("the check failed to run: {}", failure.what());
        return verdict;
    }
}

}  // namespace

std::vector<Judged> judge(const Catalogue& catalogue, const RunSetting& setting, const Progress& progress) {
    using clock = std::chrono::steady_clock;
    std::vector<Judged> judged = select(catalogue, setting);
    std::optional<clock::time_point> deadline;
    if (setting.time_limit) deadline = clock::now() + std::chrono::duration_cast<clock::duration>(*setting.time_limit);
    std::mutex progress_mutex;
    std::size_t done = 0;
    with_threads(setting.threads, [&] {
        for_batches(judged.size(), [&](std::size_t i) {
            Judged& one = judged[i];
            // Deterministic evidence takes no share; it is given the smallest one only so that it cannot use more.
            const double share = std::max(catalogue.share(*one.claim, setting.size), 1e-12);
            const Run run(setting.seed, one.id(), setting.alpha * share, setting.size, deadline);
            const auto start = clock::now();
            one.verdict = guarded(one.mutant ? one.mutant->check : one.claim->check, run);
            one.seconds = std::chrono::duration<double>(clock::now() - start).count();
            const std::lock_guard lock(progress_mutex);
            progress(one, ++done, judged.size());
        });
    });
    return judged;
}

}  // namespace plumb
