#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "estimators/integration.h"
#include "verification/runner.h"

namespace plumb {

/// Where verdicts go: an empty name writes no such file.
struct Outputs {
    std::string json, junit, report = "out/report.html", store = "out/results.db";
};

struct VerifyOptions : Outputs {
    std::vector<std::string> patterns;
    bool full = false;
    double alpha = 1e-4;
    std::optional<std::chrono::duration<double>> time_limit;
    std::optional<std::uint64_t> seed;  ///< empty: a new one
    int threads = 0;                    ///< 0: as many as the hardware has
    Shard shard;
    bool resume = false;  ///< the newest unfinished run of the store, whose settings stand
};

struct MergeOptions : Outputs {
    std::vector<std::string> stores;
};

struct ListOptions {
    std::string what;  ///< claims, mutants, integrands or estimators
    bool json = false;
};

struct ConvergeOptions {
    std::vector<std::string> estimators, integrands;
    std::vector<std::uint64_t> n;
    std::uint64_t replicates = 1000;
    std::optional<std::uint64_t> seed;
    int threads = 0;
    std::string json, report = "out/converge.html";
};

struct IntegrateOptions {
    std::vector<std::string> what;  ///< a formula, @id, an image, or files of samples
    std::optional<std::string> method;
    std::optional<std::uint64_t> n;    ///< samples a run
    std::optional<ErrorTarget> error;  ///< instead of n
    std::uint64_t replicates = 32, max_evaluations = 100'000'000;
    std::optional<std::uint64_t> batches;  ///< how many sets a file of samples is cut into
    std::vector<double> domain;            ///< x0, x1[, y0, y1]; empty: the unit cube
    std::optional<std::string> channel, lookup;
    std::optional<std::uint64_t> seed;
    int threads = 0;
    std::string json, report = "out/integrate.html";
};

struct WeightsOptions {
    std::string points, out;     ///< out: empty for standard output
    bool periodic = false;       ///< 0 and 1 are one place
    std::vector<double> domain;  ///< as above
};

struct ReportOptions {
    std::string store = "out/results.db", report = "out/report.html";
    std::optional<std::int64_t> run, against;  ///< run: empty for the newest
    bool list = false;
};

/// The program's arguments were answered already (--help, --version) or were wrong: end with this exit code.
struct Answered {
    int exit_code = 0;
};

using Options = std::variant<Answered, VerifyOptions, ListOptions, ConvergeOptions, IntegrateOptions, WeightsOptions,
                             ReportOptions, MergeOptions>;

/// Reads the command line; prints help, or a one-line error with the nearest known name, by itself.
Options parse_options(int argc, const char* const* argv);

/// "16..65536" (powers of two times the first) or "16,100,1000"; throws Error.
std::vector<std::uint64_t> parse_sample_counts(const std::string& text);
/// "90", "90s", "1.5m", "2h"; throws Error.
std::chrono::duration<double> parse_duration(const std::string& text);
/// "2/3": the second of three; throws Error.
Shard parse_shard(const std::string& text);

/// "1e-3" (absolute) or "1%" (relative); throws Error.
ErrorTarget parse_error_target(const std::string& text);
/// "0,1" or "0,2,-1,1": both ends of each axis; throws Error.
std::vector<double> parse_domain(const std::string& text);

}  // namespace plumb
