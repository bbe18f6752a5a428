#include <fmt/format.h>

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
};

}  // namespace

int main(int argc, char** argv) {
    try {
        return std::visit(Dispatch{}, plumb::parse_options(argc, argv));
    } catch (const std::exception& error) {
        fmt::print(stderr, "plumb: {}\n", error.what());
        return 2;
    }
}
