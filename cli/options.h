#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "estimators/replicates/integration.h"
#include "verification/pictures/image_comparison.h"
#include "verification/pictures/known_values.h"
#include "verification/runner.h"

namespace plumb::cli {

/// A sampler in another process, put on trial instead of the catalogue.
struct SamplerOptions {
    std::string command;  ///< of the shell, with {seed} and {n}; empty: none
    std::string density;  ///< a name or a CSV file
    double delta = 0.05;  ///< the density error phi that `holds` excludes
    std::chrono::duration<double> timeout{60};
    std::uint64_t most_samples = 100'000'000;
};

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
    SamplerOptions sampler = {};
};

struct MergeOptions : Outputs {
    std::vector<std::string> stores;  ///< or parts of a film, where there is an image to write
    std::string image;
};

struct ListOptions {
    std::string what;  ///< e.g. claims or mutants
    bool json = false;
};

struct ConvergeOptions {
    std::vector<std::string> estimators, integrands;
    std::vector<std::uint64_t> n;
    std::uint64_t replicates = 1000;
    std::optional<std::uint64_t> seed;
    int threads = 0;
    std::string images;     ///< a pattern of files that somebody has, instead of estimators and integrands
    std::string reference;  ///< of a scene: a file, "auto" for the cached one; empty: measured for the purpose
    std::string cache = "out/references";
    std::string json, report = "out/converge.html";
};

struct StudyOptions {
    std::string study;  ///< a file, or the name of a shipped one
    bool list = false;
    std::optional<std::uint64_t> seed, replicates;  ///< empty: as the study says
    int threads = 0;
    std::string out;  ///< the folder; empty: out/study-NAME
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

/// Which paths of which scene.
struct PathOptions {
    std::string scene;  ///< a file, or the name of a shipped one
    std::string integrator = "direct", sampler = "independent";
    int max_depth = -1, roulette_depth = 5;  ///< in edges; -1: no limit
    int length = 0;                          ///< in edges: paths of this length alone; 0: all
    std::vector<int> strategy;               ///< s, t of bdpt; empty: all
    std::uint32_t samples_per_pixel = 64;
    std::vector<int> crop;                           ///< x, y, width, height; empty: the whole film
    std::map<std::string, std::string> definitions;  ///< of $name in the file
    bool lenient = false;
    std::optional<std::uint64_t> seed;
};

struct RenderOptions : PathOptions {
    std::optional<std::chrono::duration<double>> time;  ///< instead of samples_per_pixel
    std::optional<ErrorTarget> error;                   ///< instead
    std::uint32_t most_samples = 1u << 16;              ///< of a pixel, where the error is not reached
    std::optional<Shard> shard;                         ///< of the passes, into a part of a film
    int threads = 0;
    std::string out;  ///< empty: out/SCENE.exr
};

/// A render with a name in the cache.
struct ReferenceOptions : RenderOptions {
    ReferenceOptions() {
        integrator = "path";
        sampler = "sobol";
        most_samples = 1u << 20;
    }
    std::string cache = "out/references";
};

/// One path of such a render.
struct ExplainOptions : PathOptions {
    int x = 0, y = 0;  ///< of the pixel
    std::uint32_t sample = 0;
    std::uint32_t replicates = 0;  ///< passes of the render; 0: as `render --spp` cuts them
    std::string json;
};

struct CompareOptions {
    std::vector<std::string> images;  ///< a and b; b may be a scene, for its reference
    std::vector<std::string> a, b;    ///< more independent renders of each
    bool exact_b = false;             ///< b is a deterministic picture
    std::string cache = "out/references";
    ComparisonSettings settings;
    std::string json, report = "out/compare.html";
};

struct CheckOptions {
    std::vector<std::string> images;  ///< independent renders of one picture
    std::string expected;             ///< a file, or the name of a shipped scene
    std::optional<int> edges;         ///< of the longest paths that count; 0: all do; empty: as the images say
    CheckSettings settings;
    std::string json;
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

using Options = std::variant<Answered, VerifyOptions, RenderOptions, ListOptions, ConvergeOptions, IntegrateOptions,
                             WeightsOptions, StudyOptions, ReportOptions, MergeOptions, CompareOptions, ExplainOptions,
                             CheckOptions, ReferenceOptions>;

/// The verbs that need nothing but a catalogue, or all those of the program that Plumb ships.
enum class VerbSet { of_a_catalogue, shipped };

/// Reads the command line; prints help, or a one-line error with the nearest known name, by itself.
Options parse_options(int argc, const char* const* argv, VerbSet verbs = VerbSet::shipped);

/// "90", "90s", "1.5m", "2h"; throws Error.
std::chrono::duration<double> parse_duration(const std::string& text);
/// "2/3": the second of three; throws Error.
Shard parse_shard(const std::string& text);

/// "1e-3" (absolute) or "1%" (relative); throws Error.
ErrorTarget parse_error_target(const std::string& text);
/// "s,t": vertices from the light and from the sensor, s >= 0, t >= 1 and not both ends alone; throws Error.
std::vector<int> parse_strategy(const std::string& text);
/// "x,y,width,height" in pixels; throws Error.
std::vector<int> parse_crop(const std::string& text);
/// "3", or "all" as 0; throws Error.
int parse_edges(const std::string& text);
/// "name=value"; throws Error.
std::pair<std::string, std::string> parse_definition(const std::string& text);
/// "0,1" or "0,2,-1,1": both ends of each axis; throws Error.
std::vector<double> parse_domain(const std::string& text);

}  // namespace plumb::cli
