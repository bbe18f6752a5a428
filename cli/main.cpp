#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "cli/commands.h"
#include "core/error.h"

namespace {

struct Dispatch {
    int operator()(const plumb::Answered& answered) const { return answered.exit_code; }
    int operator()(const plumb::VerifyOptions& options) const { return plumb::verify(options); }
    int operator()(const plumb::ListOptions& options) const { return plumb::list(options); }
    int operator()(const plumb::ConvergeOptions& options) const { return plumb::converge(options); }
    int operator()(const plumb::IntegrateOptions& options) const { return plumb::integrate(options); }
    int operator()(const plumb::WeightsOptions& options) const { return plumb::weights(options); }
    int operator()(const plumb::ReportOptions& options) const { return plumb::report(options); }
    int operator()(const plumb::MergeOptions& options) const { return plumb::merge(options); }
};

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error of writing like any other
    try {
        const int code = std::visit(Dispatch{}, plumb::parse_options(argc, argv));
        if (std::fflush(stdout) != 0) throw plumb::Error("cannot be written");
        return code;
    } catch (const std::exception& error) {
        fmt::print(stderr, "plumb: {}{}\n", std::ferror(stdout) ? "standard output: " : "", error.what());
        return 2;
    }
}
