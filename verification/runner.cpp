#include "verification/runner.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

// Throws for a pattern that matches no claim of the size class.
void check_pattern(const Catalogue& catalogue, Size size, const std::string& pattern) {
    std::vector<std::string> known;
    for (const Claim& claim : catalogue.claims())
        if (belongs(claim, size)) known.push_back(claim.id);
    if (std::ranges::any_of(known, [&](const std::string& id) { return matches(id, pattern); })) return;
    const std::string near = nearest_name(pattern, known);
    throw Error(fmt::format("no claim matches '{}'{}; `plumb list claims` shows them all", pattern,
                            near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

// The verdict on the item; empty when the run was stopped before there was one.
std::optional<Verdict> verdict_of(const Item& item, const Run& run) {
    try {
        run.end_if_stopped();
        return item.mutant ? item.mutant->judge(run) : item.claim->trial.judge(run);
    } catch (const Stopped&) {
        return {};
    } catch (const std::exception& failure) {
        Verdict verdict;
        verdict.reason = fmt::format("the check failed to run: {}", failure.what());
        return verdict;
    }
}

Verdict out_of_time() {
    Verdict verdict;
    verdict.reason = "the time limit came before a decision";
    return verdict;
}

// Asks for a stop after the time limit, unless it is destroyed before.
std::jthread alarm(std::chrono::duration<double> limit, std::stop_source source) {
    return std::jthread([limit, source](const std::stop_token& cancelled) mutable {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any().wait_for(lock, cancelled, limit, [] { return false; });
        if (!cancelled.stop_requested()) source.request_stop();
    });
}

}  // namespace

std::vector<Item> select(const Catalogue& catalogue, Size size, const std::vector<std::string>& patterns) {
    for (const std::string& pattern : patterns) check_pattern(catalogue, size, pattern);
    std::vector<Item> items;
    for (const Claim& claim : catalogue.claims()) {
        const auto wanted = [&](const std::string& pattern) { return matches(claim.id, pattern); };
        if (!belongs(claim, size)) continue;
        if (!patterns.empty() && std::ranges::none_of(patterns, wanted)) continue;
        items.push_back({&claim, nullptr, items.size()});
        for (const Mutant& mutant : claim.trial.mutants()) items.push_back({&claim, &mutant, items.size()});
    }
    return items;
}

std::vector<Item> shard_of(std::vector<Item> items, Shard shard) {
    int claims = 0, mutants = 0;
    std::erase_if(items, [&](const Item& item) {
        int& seen = item.mutant ? mutants : claims;
        return seen++ % shard.count != shard.index - 1;
    });
    return items;
}

std::vector<Judged> judge(const Catalogue& catalogue, std::span<const Item> items, const RunSetting& setting,
                          const Progress& progress) {
    using clock = std::chrono::steady_clock;
    std::stop_source end;  // by the time limit, or passed on
    const std::stop_callback pass_on(setting.stop, [&] { end.request_stop(); });
    std::jthread timer;
    if (setting.time_limit) timer = alarm(*setting.time_limit, end);

    std::vector<std::optional<Judged>> judged(items.size());
    std::mutex progress_mutex;
    std::size_t done = 0;
    with_threads(setting.threads, [&] {
        for_batches(items.size(), [&](std::size_t i) {
            const Item& item = items[i];
            // Deterministic evidence takes no share; it is given the smallest one only so that it cannot use more.
            const double share = std::max(catalogue.share(*item.claim, setting.size), 1e-12);
            const Run run(setting.seed, item.id(), setting.alpha * share, setting.size, end.get_token());
            const auto start = clock::now();
            std::optional<Verdict> verdict = verdict_of(item, run);
            const double seconds = std::chrono::duration<double>(clock::now() - start).count();
            if (!verdict && setting.stop.stop_requested()) return;
            judged[i] = Judged{item, verdict ? std::move(*verdict) : out_of_time(), seconds};
            const std::lock_guard lock(progress_mutex);
            progress(*judged[i], ++done, items.size());
        });
    });

    std::vector<Judged> finished;
    for (std::optional<Judged>& one : judged)
        if (one) finished.push_back(std::move(*one));
    return finished;
}

std::vector<Judged> judge(const Catalogue& catalogue, const RunSetting& setting, const Progress& progress) {
    return judge(catalogue, select(catalogue, setting.size, setting.patterns), setting, progress);
}

}  // namespace plumb
