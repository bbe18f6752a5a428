#include "cli/verbs.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>

#include "cli/sampler.h"
#include "core/random.h"

namespace plumb {

int CatalogueVerbs::operator()(const VerifyOptions& options) const {
    if (options.sampler.command.empty()) return verify(options, catalogue);
    VerifyOptions seeded = options;
    if (!seeded.seed) seeded.seed = fresh_seed();
    return verify(seeded, sampler_catalogue(seeded.sampler, *seeded.seed));
}

int reporting_errors(char** argv, const std::function<int()>& body) {
    try {
        return body();
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", std::filesystem::path(argv[0]).filename().string(), error.what());
        return 2;
    }
}

}  // namespace plumb
