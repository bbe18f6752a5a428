#include "cli/common_options.h"

#include "cli/values.h"
#include "core/error_target.h"
#include "core/numbers.h"

namespace plumb::cli {
namespace {

const CLI::Validator whole_number(
    [](const std::string& text) -> std::string {
        return number_of<std::uint64_t>(text) ? "" : fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
    },
    "from 0 to 2^64 - 1");

}  // namespace

const CLI::Validator& probability() {
    static const CLI::Validator in_0_1(
        [](const std::string& text) -> std::string {
            const std::optional<double> value = number_of<double>(text);
            return value && *value > 0 && *value < 1 ? "" : fmt::format("'{}' is not a number in (0, 1)", text);
        },
        "in (0, 1)");
    return in_0_1;
}

void add_seed(CLI::App& verb, std::optional<std::uint64_t>& seed) {
    verb.add_option("--seed", seed, "the run's random seed; a new one when not given, recorded either way")
        ->check(whole_number);
}

void add_seed_and_threads(CLI::App& verb, std::optional<std::uint64_t>& seed, int& threads) {
    add_seed(verb, seed);
    add_count(verb, "--threads", threads, 1, 4096,
              "worker threads, on which no result depends; as many as the machine has when not given")
        ->default_str("");
}

void add_cache(CLI::App& verb, std::string& cache) {
    verb.add_option("--cache", cache, "the folder where plumb reference keeps its pictures")->capture_default_str();
}

void add_domain(CLI::App& verb, std::vector<double>& domain) {
    add_parsed(verb, "--domain", domain, parse_domain,
               "both ends of each axis: x0,x1 or x0,x1,y0,y1; the unit interval or square when not given");
}

void add_share(CLI::App& verb, const std::string& name, double& share, const std::string& about) {
    add_parsed(
        verb, name, share, [](const std::string& text) { return parse_error_target(text).error; },
        fmt::format("{} [{} %]", about, 100 * share));
}

}  // namespace plumb::cli
