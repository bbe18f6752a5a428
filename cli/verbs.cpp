#include "cli/verbs.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "cli/outputs.h"
#include "cli/sampler.h"
#include "core/error.h"
#include "core/random.h"

namespace plumb::cli {

int CatalogueVerbs::operator()(const VerifyOptions& options) const {
    if (options.sampler.command.empty()) return verify(options, catalogue);
    check_outputs(options);  // before the sampler's work, not after it
    VerifyOptions seeded = options;
    if (!seeded.seed) seeded.seed = fresh_seed();
    return verify(seeded, sampler_catalogue(seeded.sampler, *seeded.seed, seeded.alpha));
}

int reporting_errors(char** argv, const std::function<int()>& body) {
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error of writing like any other
    try {
        const int code = body();
        if (std::fflush(stdout) != 0) throw Error("cannot be written");
        return code;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}{}\n", std::filesystem::path(argv[0]).filename().string(),
                   std::ferror(stdout) ? "standard output: " : "", error.what());
        return 2;
    }
}

}  // namespace plumb::cli
